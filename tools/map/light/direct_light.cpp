#include "tools/map/light/direct_light.h"

#include <algorithm>

namespace oblong::map {

namespace {

constexpr double kSkyDistance = 8192;
constexpr double kLeastShade = 4 / kRangeScale;  // one of the 64 shades of drawn light

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

// The points whose mean is a sample: a square, one step wide.
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

// `light_at`: the light at a point with a normal.
template <class LightAt>
void add_light_at(Samples& sums, const FaceSampler& sampler, const std::vector<std::vector<Point>>& samples,
                  LightAt light_at) {
    sums.resize(samples.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double sum = 0;
        for (const Point& point : samples[i]) sum += light_at(point, sampler.normal_at(point));
        sums[i] += sum / static_cast<double>(samples[i].size());
    }
}

}  // namespace

StyleSamples direct_light(const FaceSampler& sampler, const std::vector<const LightSource*>& sources, const Sun& sun,
                          const Tracer& tracer, bool is_fast, const std::function<void(const LightSource&)>& is_seen) {
    StyleSamples styles;
    const auto samples = sample_points(sampler, is_fast);
    for (const LightSource* source : sources) {
        double brightest = 0;
        add_light_at(styles[source->style], sampler, samples, [&](const Point& point, const Point& normal) {
            const double light = light_from(*source, point, normal, tracer);
            brightest = std::max(brightest, std::abs(light));
            return light;
        });
        if (brightest >= kLeastShade) is_seen(*source);
    }
    if (sun.brightness > 0)
        add_light_at(styles[0], sampler, samples, [&](const Point& point, const Point& normal) {
            return light_from_sun(sun, point, normal, tracer);
        });
    return styles;
}

}  // namespace oblong::map
