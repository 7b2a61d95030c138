#include "tools/map/light/lightmaps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>

#include "engine/io/wad.h"
#include "engine/surface/palette.h"
#include "tools/map/light/direct_light.h"
#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"
#include "tools/map/light/tracer.h"

namespace oblong::map {

namespace {

constexpr std::size_t kMaxStyles = 4;
constexpr int kNudge = 2;  // units by which a lamp in a wall is moved

double sum_of(const Samples& samples) {
    return std::accumulate(samples.begin(), samples.end(), 0.0,
                           [](double sum, const Light& sample) { return sum + sample.luminance; });
}

// A face can store four: removes the dimmest.
void keep_brightest(StyleSamples& styles) {
    while (styles.size() > kMaxStyles)
        styles.erase(std::min_element(styles.begin(), styles.end(), [](const auto& a, const auto& b) {
            return sum_of(a.second) < sum_of(b.second);
        }));
}

char stored(double light) {
    return static_cast<char>(static_cast<int>(std::clamp(light * kRangeScale, 0.0, 255.0)));
}

void store_styles(BspFile& bsp, FileFace& face, const StyleSamples& styles) {
    if (styles.empty()) return;
    face.light_offset = static_cast<int>(bsp.lighting.size());
    std::size_t next = 0;
    for (const auto& [style, samples] : styles) {
        face.styles[next++] = static_cast<std::uint8_t>(style);
        for (const Light& sample : samples) {
            bsp.lighting.push_back(stored(sample.luminance));
            for (const double channel : sample.channels) bsp.coloured_lighting.push_back(stored(channel));
        }
    }
}

// The first position outside walls 2 units away along an axis: samples are 1 unit above their faces.
std::optional<Point> place_beside_wall(const Point& point, const Tracer& tracer) {
    for (int direction = 0; direction < 6; ++direction) {
        Point place = point;
        place[direction / 2] += direction % 2 == 0 ? -kNudge : kNudge;
        if (!tracer.is_solid(place)) return place;
    }
    return std::nullopt;
}

// As in ericw-tools' `light`. Lamps deeper in a wall light nothing; lamps with a radius may be inside their own body.
void move_out_of_walls(std::vector<LightSource>& sources, const Tracer& tracer, Warnings& warnings) {
    for (LightSource& source : sources) {
        if (source.radius > 0 || !tracer.is_solid(source.origin)) continue;
        if (const auto place = place_beside_wall(source.origin, tracer))
            source.origin = *place;
        else
            warnings.add(source.entity->line,
                         "the " + source.entity->value("classname") + " at " + source.entity->value("origin") +
                             " is inside a wall and lights nothing, expected an open place within " +
                             std::to_string(kNudge) + " units");
    }
}

// A model's faces are consecutive.
std::vector<Light> least_light_of_faces(const BspFile& bsp, const std::vector<Light>& of_models) {
    std::vector<Light> least;
    for (std::size_t model = 0; model < bsp.models.size(); ++model)
        least.insert(least.end(), as_size(bsp.models[model].face_count), of_models[model]);
    return least;
}

Light reflected_by(const Rgb8& colour) {
    return {luminance_1000(colour) / 255'000.0, {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0}};
}

// The share of light that each texture reflects: the mean of its texels. `colour`: HemisphereSettings::bounce_colour.
std::vector<Light> reflectances(const BspFile& bsp, const Palette* palette, double colour) {
    constexpr Light kHalf{0.5, {0.5, 0.5, 0.5}};
    std::vector<Light> shares;
    for (const std::string& miptex : bsp.textures) {
        const MipTexture texture = parse_miptex({reinterpret_cast<const std::uint8_t*>(miptex.data()), miptex.size()});
        const auto& texels = texture.mips.back();
        Light sum;
        for (const std::uint8_t texel : texels)
            sum += palette == nullptr ? kHalf : reflected_by(item(palette->colours, texel));
        sum /= static_cast<double>(texels.size());
        for (double& channel : sum.channels) channel = std::lerp(sum.luminance, channel, colour);
        shares.push_back(texels.empty() ? kHalf : sum);
    }
    return shares;
}

// Lights the faces of a level.
class LightPass {
  public:
    LightPass(BspFile& bsp, const std::vector<MapEntity>& entities, const LightOptions& options, Warnings& warnings,
              const WorkSharing& sharing)
        : bsp_(bsp),
          options_(options),
          warnings_(warnings),
          sharing_(sharing),
          lights_(lights_of(entities)),
          tracer_(bsp, lights_.shadow_models) {
        if (options.has_dirt) lights_.hemisphere.has_dirt = true;
        if (options.has_bounce) lights_.hemisphere.bounces = std::max(lights_.hemisphere.bounces, 1);
        spread_surface_lights(lights_.sources, bsp, warnings);
        spread_deviant_lights(lights_.sources);
        move_out_of_walls(lights_.sources, tracer_, warnings);
        samplers_.resize(bsp.faces.size());
        styles_.resize(bsp.faces.size());
    }

    void run() {
        add_direct_light();
        if (lights_.hemisphere.is_needed()) add_hemisphere_light();
        store();
    }

  private:
    SurfaceLight surface_of(std::size_t face) const {
        const std::size_t texinfo = as_size(bsp_.faces[face].texinfo);
        return texinfo < options_.surfaces.size() ? options_.surfaces[texinfo] : SurfaceLight{};
    }

    void add_direct_light() {
        std::vector<SmoothFace> smooth = smooth_faces(bsp_, options_.surfaces);
        sharing_.for_each(samplers_.size(), [&](std::size_t i) {
            if (item(bsp_.texinfos, bsp_.faces[i].texinfo).flags == 0)
                samplers_[i].emplace(bsp_, bsp_.faces[i], std::move(smooth[i]), samplers_, tracer_);
        });
        const std::vector<BitSet> reached = faces_reached(bsp_, tracer_, lights_.sources, sharing_);
        std::vector<std::atomic<bool>> seen(lights_.sources.size());
        sharing_.begin("light", samplers_.size());
        sharing_.for_each(samplers_.size(), [&](std::size_t i) {
            if (!samplers_[i] || surface_of(i).ignores_light) return;
            const FaceSampler& sampler = *samplers_[i];
            const auto sources = sources_near(lights_.sources, reached, i, sampler);
            styles_[i] =
                direct_light(sampler, sources, lights_.sun, tracer_, options_.is_fast, [&](const LightSource& source) {
                    seen[static_cast<std::size_t>(&source - lights_.sources.data())] = true;
                });
        });
        std::set<const MapEntity*> shining;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i]) shining.insert(lights_.sources[i].entity);
        for (const LightSource& source : lights_.sources)
            if (shining.insert(source.entity).second && !tracer_.is_solid(source.origin))
                warnings_.add(source.entity->line,
                              "the " + source.entity->value("classname") + " at " + source.entity->value("origin") +
                                  " lights no face visibly, expected a larger \"light\", or a place nearer to a face");
    }

    // The first pass is for sky, dirt and the first bounce; each further pass is for a bounce.
    void add_hemisphere_light() {
        const HemisphereSettings& settings = lights_.hemisphere;
        std::vector<StyleSamples> last = styles_;
        if (!settings.is_bounce_styled)
            for (StyleSamples& styles : last) std::erase_if(styles, [](const auto& style) { return style.first != 0; });
        const std::vector<Light> reflected = reflectances(bsp_, options_.palette, settings.bounce_colour);
        for (int bounce = 0; bounce < std::max(settings.bounces, 1); ++bounce) {
            const AddLight add_reflected = [&](const Point& point, const RayHit& hit, const Point& direction,
                                               double share, StyleLight& light) {
                add_light_of_surface(point, hit, direction, last, reflected, share, light);
            };
            std::vector<StyleSamples> next(samplers_.size());
            sharing_.begin("bounced light", samplers_.size());
            sharing_.for_each(samplers_.size(), [&](std::size_t i) {
                if (!samplers_[i] || surface_of(i).ignores_light) return;
                const std::vector<Hemisphere> seen =
                    seen_from(*samplers_[i], settings.bounces > 0 ? add_reflected : AddLight());
                if (bounce == 0) add_sky_and_dirt(i, seen);
                for (std::size_t k = 0; k < seen.size(); ++k)
                    for (const auto& [style, light] : seen[k].light) sample_of(next[i], style, k, seen.size()) = light;
            });
            for (std::size_t i = 0; i < next.size(); ++i)
                for (const auto& [style, samples] : next[i])
                    for (std::size_t k = 0; k < samples.size(); ++k)
                        sample_of(styles_[i], style, k, samples.size()) += samples[k];
            last = std::move(next);
        }
    }

    static Light& sample_of(StyleSamples& styles, int style, std::size_t sample, std::size_t count) {
        Samples& samples = styles[style];
        samples.resize(count);
        return samples[sample];
    }

    void add_sky_and_dirt(std::size_t face, const std::vector<Hemisphere>& seen) {
        const HemisphereSettings& settings = lights_.hemisphere;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            darken(face, k, seen[k]);
            Light above = settings.sunlight2, below = settings.sunlight3;
            above *= seen[k].sky_above;
            above += below *= seen[k].sky_below;
            sample_of(styles_[face], 0, k, seen.size()) += above;
        }
    }

    void darken(std::size_t face, std::size_t sample, const Hemisphere& seen) {
        const HemisphereSettings& settings = lights_.hemisphere;
        if (!settings.has_dirt || surface_of(face).has_no_dirt) return;
        const double dirt = std::clamp(std::pow(seen.shut, settings.dirt_gain) * settings.dirt_scale, 0.0, 1.0);
        for (auto& [style, samples] : styles_[face]) samples[sample] *= 1 - dirt;
    }

    // Light is nearly the same at neighbouring samples, so that each traces a ninth of the rays, and the mean of nine
    // neighbours covers all. In a draft, one of each square of nine traces for all of them.
    std::vector<Hemisphere> seen_from(const FaceSampler& sampler, const AddLight& add_reflected) const {
        const int rings = options_.is_fast ? 4 : 8;
        const auto [width, height] = sampler.grid().count;
        std::vector<Hemisphere> alone;
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u) {
                const int first_u = u - u % 3, first_v = v - v % 3;
                if (options_.is_fast && (u != first_u || v != first_v)) {
                    alone.push_back(alone[as_size(first_v * width + first_u)]);
                    continue;
                }
                const auto [point, normal] = sampler.place_at(u, v);
                alone.push_back(gather(point, normal, rings, u % 3 + 3 * (v % 3), lights_.hemisphere.dirt_depth,
                                       tracer_, add_reflected));
            }
        std::vector<Hemisphere> smooth;
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u) smooth.push_back(mean_around(alone, u, v, width, height));
        return smooth;
    }

    static Hemisphere mean_around(const std::vector<Hemisphere>& all, int u, int v, int width, int height) {
        Hemisphere sum;
        int count = 0;
        for (int y = std::max(v - 1, 0); y <= std::min(v + 1, height - 1); ++y)
            for (int x = std::max(u - 1, 0); x <= std::min(u + 1, width - 1); ++x, ++count) {
                const Hemisphere& each = item(all, y * width + x);
                sum.sky_above += each.sky_above;
                sum.sky_below += each.sky_below;
                sum.shut += each.shut;
                for (const auto& [style, light] : each.light) sum.light[style] += light;
            }
        for (auto& [style, light] : sum.light) light /= count;
        return {sum.sky_above / count, sum.sky_below / count, sum.shut / count, std::move(sum.light)};
    }

    // Adds the light that the face at a ray's end reflects, times `share`.
    void add_light_of_surface(const Point& point, const RayHit& hit, const Point& direction,
                              const std::vector<StyleSamples>& light, const std::vector<Light>& reflected, double share,
                              StyleLight& sum) const {
        if (hit.node < 0) return;
        const FileNode& node = item(bsp_.nodes, hit.node);
        const bool is_back = dot(to_point(item(bsp_.planes, node.plane).normal), direction) > 0;
        for (int i = node.first_face; i < node.first_face + node.face_count; ++i) {
            const FileFace& face = item(bsp_.faces, i);
            if ((face.is_back != 0) != is_back || !item(samplers_, i)) continue;
            const auto sample = item(samplers_, i)->sample_at(point);
            if (!sample) continue;
            const Light& reflectance = item(reflected, item(bsp_.texinfos, face.texinfo).texture);
            for (const auto& [style, samples] : item(light, i)) {
                Light part = samples[*sample];
                part *= reflectance;
                part *= lights_.hemisphere.bounce_scale;
                sum[style] += part *= share;
            }
            return;
        }
    }

    void store() {
        const std::vector<Light> least_of_models = least_light_of_faces(bsp_, lights_.least);
        for (std::size_t i = 0; i < styles_.size(); ++i) {
            if (!samplers_[i]) continue;
            const Light least = surface_of(i).least.raise_to(least_of_models[i]);
            if (least.luminance > 0) {
                Samples& steady = styles_[i][0];
                steady.resize(as_size(samplers_[i]->grid().count[0] * samplers_[i]->grid().count[1]));
                for (Light& sample : steady) sample.raise_to(least);
            }
            std::erase_if(styles_[i], [](const auto& style) {
                return std::all_of(style.second.begin(), style.second.end(),
                                   [](const Light& sample) { return sample.brightest() < 1; });
            });
            keep_brightest(styles_[i]);
            store_styles(bsp_, bsp_.faces[i], styles_[i]);
        }
        if (!lights_.is_coloured) bsp_.coloured_lighting.clear();
    }

    BspFile& bsp_;
    const LightOptions& options_;
    Warnings& warnings_;
    const WorkSharing& sharing_;
    Lights lights_;
    Tracer tracer_;
    FaceSamplers samplers_;
    std::vector<StyleSamples> styles_;  // by face
};

}  // namespace

void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, const LightOptions& options, Warnings& warnings,
               const WorkSharing& sharing) {
    LightPass(bsp, entities, options, warnings, sharing).run();
}

}  // namespace oblong::map
