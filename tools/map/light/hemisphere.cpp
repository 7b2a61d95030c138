#include "tools/map/light/hemisphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblong::map {
namespace {

constexpr double kFar = 8192;

// Two directions perpendicular to a normal and to each other.
std::array<Point, 2> tangents(const Point& normal) {
    const Point aside = cross(normal, axis_vector(std::abs(normal.z) < 0.7 ? 2 : 0));
    const Point first = aside * (1 / length(aside));
    return {first, cross(normal, first)};
}

}  // namespace

Hemisphere HemisphereRays::gather(const Point& point, const Point& normal, int pattern, double dirt_depth,
                                  const Tracer& tracer, const AddLight& add_reflected) const {
    const auto [right, up] = tangents(normal);
    const double shift = (pattern + 0.5) / patterns_, turn = static_cast<double>(2 * pattern % patterns_) / patterns_;
    const double share = 1.0 / (rings_ * rings_);
    Hemisphere seen;
    for (int ring = 0; ring < rings_; ++ring) {
        const double sine_squared = (ring + shift) / rings_;  // evenly spaced, for Lambert's law
        const double sine = std::sqrt(sine_squared), cosine = std::sqrt(1 - sine_squared);
        for (int i = 0; i < rings_; ++i) {
            const double angle = 2 * std::numbers::pi * (i + turn + 0.5 * (ring % 2)) / rings_;
            const Point direction = right * (sine * std::cos(angle)) + up * (sine * std::sin(angle)) + normal * cosine;
            const RayHit hit = tracer.hit(point, point + direction * kFar);
            if (hit.contents == contents::kSky) (direction.z >= 0 ? seen.sky_above : seen.sky_below) += share;
            if (hit.contents != contents::kSolid) continue;
            seen.shut += share * std::max(1 - hit.share * kFar / dirt_depth, 0.0);
            if (add_reflected) add_reflected(point + direction * (kFar * hit.share), hit, direction, share, seen.light);
        }
    }
    return seen;
}

}  // namespace oblong::map
