#include "tools/map/light/lightmaps.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "tools/map/light/sources.h"
#include "tools/map/source/brush.h"
#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

constexpr double kRangeScale = 0.5;
constexpr std::size_t kMaxStyles = 4;
constexpr double kSkyDistance = 8192;
constexpr int kNudge = 2;  // units that a lamp in a wall is moved

using Samples = std::vector<double>;
using StyleSamples = std::map<int, Samples>;

double incidence(double cosine) {
    return (1 + cosine) / 2;
}

double light_from(const LightSource& source, const Point& point, const Point& normal, const Tracer& tracer) {
    const Point towards = point - source.origin;
    const double distance = length(towards);
    if (distance == 0 || distance >= source.range()) return 0;
    const double cosine = -dot(towards, normal) / distance;
    if (cosine <= 0 || !source.shines_on(towards * (1 / distance))) return 0;
    const double light = source.at_distance(distance) * incidence(cosine);
    const Point edge_of_lamp = source.origin + towards * std::min(source.radius / distance, 1.0);
    if (light <= 0 || !tracer.is_lit(point, edge_of_lamp)) return 0;
    return source.is_subtracted ? -light : light;
}

double light_from_sun(const Sun& sun, const Point& point, const Point& normal, const Tracer& tracer) {
    const double cosine = -dot(sun.direction, normal);
    if (cosine <= 0) return 0;
    const int met = tracer.first_opaque(point, point - sun.direction * kSkyDistance);
    return met == contents::kSky ? sun.brightness * incidence(cosine) : 0;
}

// The points that each sample is the mean of: a square of them, a step wide.
std::vector<std::vector<Point>> sample_points(const FaceSampler& sampler, bool is_fast) {
    const std::vector<double> offsets =
        is_fast ? std::vector<double>{0} : std::vector<double>{-0.375, -0.125, 0.125, 0.375};
    std::vector<std::vector<Point>> samples;
    for (int v = 0; v < sampler.grid().count[1]; ++v) {
        for (int u = 0; u < sampler.grid().count[0]; ++u) {
            auto& points = samples.emplace_back();
            for (const double du : offsets) {
                for (const double dv : offsets) points.push_back(sampler.point_at(u + du, v + dv));
            }
        }
    }
    return samples;
}

template <class LightAt>
void add_light_at(Samples& sums, const std::vector<std::vector<Point>>& samples, LightAt light_at) {
    sums.resize(samples.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double sum = 0;
        for (const Point& point : samples[i]) sum += light_at(point);
        sums[i] += sum / static_cast<double>(samples[i].size());
    }
}

StyleSamples light_face(const FaceSampler& sampler, const std::vector<const LightSource*>& sources, const Sun& sun,
                        double least, const Tracer& tracer, bool is_fast) {
    StyleSamples styles;
    const auto samples = sample_points(sampler, is_fast);
    for (const LightSource* source : sources)
        add_light_at(styles[source->style], samples,
                     [&](const Point& point) { return light_from(*source, point, sampler.normal(), tracer); });
    if (sun.brightness > 0)
        add_light_at(styles[0], samples,
                     [&](const Point& point) { return light_from_sun(sun, point, sampler.normal(), tracer); });
    if (least > 0) {
        styles[0].resize(samples.size(), 0);
        for (double& sample : styles[0]) sample = std::max(sample, least);
    }
    std::erase_if(styles, [](const auto& style) {
        return std::all_of(style.second.begin(), style.second.end(), [](double sample) { return sample < 1; });
    });
    return styles;
}

double sum_of(const Samples& samples) {
    return std::accumulate(samples.begin(), samples.end(), 0.0);
}

// A face has room for four: the dimmest go.
void keep_brightest(StyleSamples& styles) {
    while (styles.size() > kMaxStyles)
        styles.erase(std::min_element(styles.begin(), styles.end(), [](const auto& a, const auto& b) {
            return sum_of(a.second) < sum_of(b.second);
        }));
}

void store(BspFile& bsp, FileFace& face, const StyleSamples& styles) {
    if (styles.empty()) return;
    face.light_offset = static_cast<int>(bsp.lighting.size());
    std::size_t next = 0;
    for (const auto& [style, samples] : styles) {
        face.styles[next++] = static_cast<std::uint8_t>(style);
        for (const double sample : samples)
            bsp.lighting.push_back(static_cast<char>(static_cast<int>(std::clamp(sample * kRangeScale, 0.0, 255.0))));
    }
}

bool is_sky(const BspFile& bsp, const FileFace& face) {
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    return texinfo.flags != 0 && contents_of_texture(item(bsp.textures, texinfo.texture)) == contents::kSky;
}

// Which faces of the world each source may light, by the sets of potentially visible leaves: spares most rays.
class LightReach {
  public:
    LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources);

    // True for faces of brush entities always: they move.
    bool may_light(std::size_t source, std::size_t face) const {
        return face >= world_face_count_ || reached_[source][face];
    }

  private:
    std::size_t world_face_count_;
    std::vector<std::vector<bool>> reached_;  // of each source, by face
};

LightReach::LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources)
    : world_face_count_(static_cast<std::size_t>(bsp.models.front().face_count)) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    for (const LightSource& source : sources) {
        auto& reached = reached_.emplace_back(world_face_count_, false);
        const FileLeaf& home = item(bsp.leaves, tracer.leaf_at(source.origin));
        bool sees_sky = home.contents == contents::kSky;
        const std::vector<bool> seen = unpacked_row(bsp.visibility, home.visibility_offset, leaf_count);
        for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
            if (!seen[leaf]) continue;
            const FileLeaf& marks = bsp.leaves[leaf + 1];
            for (int i = 0; i < marks.mark_face_count; ++i) {
                const int face = item(bsp.mark_faces, marks.first_mark_face + i);
                item(reached, face) = true;
                sees_sky = sees_sky || is_sky(bsp, item(bsp.faces, face));
            }
        }
        if (sees_sky) reached.assign(world_face_count_, true);  // what is behind a sky is in no set
    }
}

// Sources that may light some of the face.
std::vector<const LightSource*> sources_near(const Lights& lights, const LightReach& reach, std::size_t face,
                                             const FaceSampler& sampler) {
    std::vector<const LightSource*> near;
    for (std::size_t i = 0; i < lights.sources.size(); ++i) {
        const LightSource& source = lights.sources[i];
        const Point towards = source.origin - sampler.centre();
        if (dot(towards, sampler.normal()) <= 0 || length(towards) > source.range() + sampler.radius()) continue;
        if (reach.may_light(i, face)) near.push_back(&source);
    }
    return near;
}

// The first place 2 units along an axis that is no wall: samples are 1 unit over their faces.
std::optional<Point> place_beside_wall(const Point& point, const Tracer& tracer) {
    for (int direction = 0; direction < 6; ++direction) {
        Point place = point;
        place[direction / 2] += direction % 2 == 0 ? -kNudge : kNudge;
        if (!tracer.is_solid(place)) return place;
    }
    return std::nullopt;
}

// As ericw-tools' `light` does. Lamps deeper in a wall light nothing; those with a radius may stand in their own body.
void move_out_of_walls(std::vector<LightSource>& sources, const Tracer& tracer, Warnings* warnings) {
    for (LightSource& source : sources) {
        if (source.radius > 0 || !tracer.is_solid(source.origin)) continue;
        if (const auto place = place_beside_wall(source.origin, tracer))
            source.origin = *place;
        else if (warnings != nullptr)
            warnings->add(source.entity->line, "the " + source.entity->value("classname") + " at " +
                                                   source.entity->value("origin") +
                                                   " is in a wall and lights nothing, expected open air within " +
                                                   std::to_string(kNudge) + " units");
    }
}

}  // namespace

void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, bool is_fast, Warnings* warnings) {
    Lights lights = lights_of(entities);
    const Tracer tracer(bsp);
    move_out_of_walls(lights.sources, tracer, warnings);
    const LightReach reach(bsp, tracer, lights.sources);
    for (std::size_t model = 0; model < bsp.models.size(); ++model) {
        const int first = bsp.models[model].first_face, end = first + bsp.models[model].face_count;
        for (int i = first; i < end; ++i) {
            FileFace& face = item(bsp.faces, i);
            if (item(bsp.texinfos, face.texinfo).flags != 0) continue;
            const FaceSampler sampler(bsp, face, tracer);
            const auto sources = sources_near(lights, reach, static_cast<std::size_t>(i), sampler);
            StyleSamples styles = light_face(sampler, sources, lights.sun, lights.least[model], tracer, is_fast);
            keep_brightest(styles);
            store(bsp, face, styles);
        }
    }
}

Tracer::Tracer(const BspFile& bsp) : root_(bsp.models.front().head_nodes[0]) {
    for (const FileNode& node : bsp.nodes) {
        const FilePlane& plane = item(bsp.planes, node.plane);
        nodes_.push_back({to_point(plane.normal), static_cast<double>(plane.distance), node.children});
    }
    for (const FileLeaf& leaf : bsp.leaves) opaque_.push_back(is_opaque(leaf.contents) ? leaf.contents : 0);
}

int Tracer::leaf_at(const Point& point) const {
    int child = root_;
    while (child >= 0) {
        const TraceNode& node = item(nodes_, child);
        child = node.children[dot(node.normal, point) < node.distance ? 1 : 0];
    }
    return -1 - child;
}

int Tracer::follow(int child, const Point& from, const Point& to, bool stops_at_sky) const {
    while (child >= 0) {
        const TraceNode& node = item(nodes_, child);
        const double from_height = dot(node.normal, from) - node.distance;
        const double to_height = dot(node.normal, to) - node.distance;
        const std::size_t near = from_height < 0 ? 1 : 0, far = to_height < 0 ? 1 : 0;
        if (near != far) {
            const Point at = from + (to - from) * (from_height / (from_height - to_height));
            const int hit = follow(node.children[near], from, at, stops_at_sky);
            return hit != 0 ? hit : follow(node.children[far], at, to, stops_at_sky);
        }
        child = node.children[near];
    }
    const int met = item(opaque_, -1 - child);
    return met == contents::kSky && !stops_at_sky ? 0 : met;
}

}  // namespace oblong::map
