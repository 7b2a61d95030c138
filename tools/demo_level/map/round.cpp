#include <algorithm>
#include <cmath>

#include "tools/demo_level/map/room.h"

namespace oblong::map_source {
namespace {

/// A ring of the sphere: its height above the centre, and its radius in 64ths of the sphere's.
struct Ring {
    double height, radius_64;
};

/// Where a sphere stands, and how large it is beside the rings below.
struct Place {
    Point centre;
    double scale;
};

/// Every ring is the same polygon scaled, so that the edges above and below a facet are parallel and its four corners
/// lie on one plane, exactly. Cosines of multiples of 15 degrees, times 56, and sines, times 64.
constexpr std::array<Ring, 13> kRings{{{56, 0},
                                       {54, 16.5},
                                       {48.5, 32},
                                       {39.5, 45.25},
                                       {28, 55.5},
                                       {14.5, 61.75},
                                       {0, 64},
                                       {-14.5, 61.75},
                                       {-28, 55.5},
                                       {-39.5, 45.25},
                                       {-48.5, 32},
                                       {-54, 16.5},
                                       {-56, 0}}};

/// The polygon of the widest ring: corners in quarters of a unit.
std::vector<std::array<double, 2>> equator() {
    auto corners = circle(24, 0, 0, 4 * 56, 0);
    for (auto& corner : corners) corner = {corner[0] / 4, corner[1] / 4};
    return corners;
}

Point ring_point(const Place& place, const Ring& ring, const std::array<double, 2>& corner) {
    const double across = place.scale * ring.radius_64 / 64;
    return {place.centre.x + corner[0] * across, place.centre.y + corner[1] * across,
            place.centre.z + ring.height * place.scale};
}

/// Three points of a facet: both corners of its wider edge and one of the other (a pole's edge is a point).
std::vector<Point> facet(const Place& place, const Ring& upper, const Ring& lower, const std::array<double, 2>& corner,
                         const std::array<double, 2>& next_corner) {
    const bool is_upper = upper.radius_64 < lower.radius_64;
    const Ring &wide = is_upper ? lower : upper, &narrow = is_upper ? upper : lower;
    return {ring_point(place, wide, corner), ring_point(place, wide, next_corner), ring_point(place, narrow, corner)};
}

/// Where the ray from the middle of a square through `corner` meets its outline, rounded to whole units.
std::array<double, 2> on_square(const std::array<double, 2>& corner, double x, double z, double half) {
    const double across = corner[0] - x, up = corner[1] - z;
    const double reach = std::max(std::abs(across), std::abs(up));
    return {x + std::round(across * half / reach), z + std::round(up * half / reach)};
}

}  // namespace

Brush make_sphere(const Point& centre, double scale, const std::string& even_texture, const std::string& odd_texture,
                  std::size_t coarseness) {
    const auto polygon = equator();
    Brush sphere;
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ring += coarseness) {
        for (std::size_t i = 0; i < polygon.size(); i += coarseness) {
            const auto points = facet({centre, scale}, kRings[ring], kRings[ring + coarseness], polygon[i],
                                      polygon[(i + coarseness) % polygon.size()]);
            const std::string& texture = (ring + i) / coarseness % 2 == 0 ? even_texture : odd_texture;
            sphere.faces.push_back(make_solid({points}, centre, texture).faces.front());
        }
    }
    return sphere;
}

void add_round_window(Draft& draft, double x, double z, double y_low, double half, double radius, const Skin& skin) {
    constexpr double kDepth = 32;
    const auto hole = circle(24, x, z, radius, 0);
    for (std::size_t i = 0; i < hole.size(); ++i) {
        const auto &corner = hole[i], &next = hole[(i + 1) % hole.size()];
        const Outline sector{1, {corner, on_square(corner, x, z, half), on_square(next, x, z, half), next}};
        draft.add_detail(extrude(sector, y_low, y_low + kDepth, skin));
    }
}

}  // namespace oblong::map_source
