#include "tools/map/light/direct_light.h"

#include <algorithm>
#include <cmath>

#include "tools/map/vis/visibility.h"

namespace oblong::map {
namespace {

bool is_sky(const BspFile& bsp, const FileFace& face) {
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    return texinfo.flags != 0 && contents_of_texture(item(bsp.textures, texinfo.texture)) == contents::kSky;
}

constexpr double kSkyDistance = 8192;
constexpr double kLeastShade = 4 / kRangeScale;  // one of the 64 shades of drawn light

double incidence(double cosine, double angle_share) {
    return 1 - angle_share + angle_share * cosine;
}

// `range`: the source's.
double light_from(const LightSource& source, double range, const Point& point, const Point& normal,
                  const Tracer& tracer) {
    const Point towards = point - source.origin;
    const double distance = length(towards);
    if (distance == 0 || distance >= range) return 0;
    const double cosine = -dot(towards, normal) / distance;
    const double share = source.share_towards(towards * (1 / distance));
    if (cosine <= 0 || share <= 0) return 0;
    const double light = source.at_distance(distance) * share * incidence(cosine, source.angle_share);
    const Point edge_of_lamp = source.origin + towards * std::min(source.radius / distance, 1.0);
    if (light <= 0 || !tracer.is_lit(point, edge_of_lamp)) return 0;
    return source.is_subtracted ? -light : light;
}

// The direction to the i-th of `count` points of the sun's disc.
Point towards_sun(const Sun& sun, std::size_t i, std::size_t count) {
    if (sun.penumbra_radius <= 0 || count < 2) return sun.direction * -1;
    const auto [right, up] = tangents(sun.direction);
    const double radius = sun.penumbra_radius * std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(count)),
                 angle = static_cast<double>(i) * kGoldenAngle;
    return unit(right * (radius * std::cos(angle)) + up * (radius * std::sin(angle)) - sun.direction);
}

// From the i-th point of a disc of `count`.
double light_from_sun(const Sun& sun, std::size_t i, std::size_t count, const LitPoint& lit, const Tracer& tracer) {
    const double cosine = -dot(sun.direction, lit.normal);
    if (cosine <= 0) return 0;
    const int met = tracer.first_opaque(lit.point, lit.point + towards_sun(sun, i, count) * kSkyDistance);
    return met == contents::kSky ? sun.brightness * incidence(cosine, sun.angle_share) : 0;
}

// A face's samples: each is the mean at some points of a square, one step wide.
class PointsOfSamples {
  public:
    PointsOfSamples(const FaceSampler& sampler, bool is_fast) : per_sample_(is_fast ? 1 : 16) {
        const std::vector<double> offsets =
            is_fast ? std::vector<double>{0} : std::vector<double>{-0.375, -0.125, 0.125, 0.375};
        const auto [width, height] = sampler.grid().count;
        points_.reserve(as_size(width * height) * per_sample_);
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u)
                for (const double du : offsets)
                    for (const double dv : offsets) points_.push_back(sampler.place_at(u + du, v + dv));
    }

    std::size_t per_sample() const { return per_sample_; }

    // `light_at`: the luminance at a point, which is the k-th of its sample.
    template <class LightAt>
    void add_light(Samples& sums, const Hue& hue, LightAt light_at) const {
        sums.resize(points_.size() / per_sample_);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < per_sample_; ++k) sum += light_at(points_[i * per_sample_ + k], k);
            sums[i] += hue.of(sum / static_cast<double>(per_sample_));
        }
    }

  private:
    std::size_t per_sample_;
    std::vector<LitPoint> points_;
};

}  // namespace

std::vector<BitSet> faces_reached(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources,
                                  const WorkSharing& sharing) {
    std::vector<BitSet> reached(sources.size(), BitSet(bsp.faces.size()));
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    sharing.for_each(sources.size(), [&](std::size_t i) {
        const FileLeaf& home = item(bsp.leaves, tracer.leaf_at(sources[i].origin));
        bool sees_sky = home.contents == contents::kSky;
        unpacked_row(bsp.visibility, home.visibility_offset, leaf_count).for_each([&](std::size_t leaf) {
            const FileLeaf& marks = bsp.leaves[leaf + 1];
            for (int k = 0; k < marks.mark_face_count; ++k) {
                const int face = item(bsp.mark_faces, marks.first_mark_face + k);
                reached[i].add(as_size(face));
                sees_sky = sees_sky || is_sky(bsp, item(bsp.faces, face));
            }
        });
        // Faces behind a sky are in no set.
        const std::size_t first = sees_sky ? 0 : as_size(bsp.models.front().face_count);
        for (std::size_t face = first; face < bsp.faces.size(); ++face) reached[i].add(face);
    });
    return reached;
}

std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources,
                                             const std::vector<BitSet>& reached, std::size_t face,
                                             const FaceSampler& sampler) {
    std::vector<const LightSource*> near;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (!reached[i].has(face)) continue;
        const LightSource& source = sources[i];
        const Point towards = source.origin - sampler.centre();
        if ((sampler.is_smooth() || dot(towards, sampler.normal()) > 0) &&
            length(towards) <= source.range() + sampler.radius())
            near.push_back(&source);
    }
    return near;
}

StyleSamples direct_light(const FaceSampler& sampler, const std::vector<const LightSource*>& sources, const Sun& sun,
                          const Tracer& tracer, bool is_fast, const std::function<void(const LightSource&)>& is_seen) {
    StyleSamples styles;
    const PointsOfSamples samples(sampler, is_fast);
    for (const LightSource* source : sources) {
        double brightest = 0;
        const double range = source->range();
        samples.add_light(styles[source->style], source->hue, [&](const LitPoint& lit, std::size_t) {
            const double light = light_from(*source, range, lit.point, lit.normal, tracer);
            brightest = std::max(brightest, std::abs(light));
            return light;
        });
        if (brightest >= kLeastShade) is_seen(*source);
    }
    if (sun.brightness > 0)
        samples.add_light(styles[0], sun.hue, [&](const LitPoint& lit, std::size_t k) {
            return light_from_sun(sun, k, samples.per_sample(), lit, tracer);
        });
    return styles;
}

}  // namespace oblong::map
