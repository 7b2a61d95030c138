#include "tools/accuracy/scene_map.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <vector>

#include "engine/base/table.h"
#include "engine/io/wad.h"
#include "engine/surface/palette.h"
#include "tools/texture/texture_files.h"

namespace oblong {

namespace {

using map::MapBrush;
using map::MapSide;
using map::Point;

constexpr double kWall = 16;

MapSide make_side(const std::vector<Point>& polygon, const Point& inside, const std::string& texture, double units) {
    MapSide side;
    side.points = {polygon[0], polygon[1], polygon[2]};
    const Point outwards = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
    if (dot(outwards, inside - polygon[0]) > 0) std::swap(side.points[0], side.points[2]);
    side.texture.name = texture;
    side.texture.scale = {units, units};
    return side;
}

/// A convex polygon of the plane z = 0 extruded from `low` to `high`.
MapBrush extrude(const std::vector<std::array<double, 2>>& outline, double low, double high, const std::string& texture,
                 double units) {
    std::vector<Point> bottom, top;
    Point middle{0, 0, (low + high) / 2};
    for (const auto& [x, y] : outline) {
        bottom.push_back({x, y, low});
        top.push_back({x, y, high});
        middle.x += x / static_cast<double>(outline.size());
        middle.y += y / static_cast<double>(outline.size());
    }
    std::vector<std::vector<Point>> polygons{bottom, top};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        polygons.push_back({bottom[i], bottom[next], top[next]});
    }
    return make_solid(polygons, middle, texture, units);
}

/// A ring of the sphere: its height above the centre, and its radius in 64ths of the sphere's.
struct Ring {
    double height, radius_64;
};

/// Every ring is the same polygon scaled, so that the edges above and below a facet are parallel and its four corners
/// are exactly coplanar. Cosines of multiples of 15 degrees, times 56, and sines, times 64.
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
constexpr std::size_t kCorners = 24;  // of a ring

/// A corner of a ring; those of the widest one are quarters of a unit.
Point ring_point(const Point& centre, const Ring& ring, std::size_t corner) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(corner) / kCorners;
    const auto part = [&](double of_circle) { return std::round(4 * 56 * of_circle) / 4 * ring.radius_64 / 64; };
    return centre + Point{part(std::cos(angle)), part(std::sin(angle)), ring.height};
}

constexpr std::int32_t kSize = 64;

/// A pseudo-random number, 0 to 31.
int grain(std::int32_t u, std::int32_t v) {
    auto bits = static_cast<std::uint32_t>(u * 7919 + v * 104729);
    bits = (bits ^ bits >> 13) * 1274126177u;
    return static_cast<int>(bits >> 27);
}

std::uint8_t channel(int value) {
    return static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
}

/// Blocks `block_width` by `block_height` texels in two alternating shades, with dark joints.
MipTexture make_texture(const std::string& name, std::int32_t block_width, std::int32_t block_height, Rgb8 light,
                        const Palette& palette) {
    std::vector<std::uint8_t> texels;
    for (std::int32_t v = 0; v < kSize; ++v)
        for (std::int32_t u = 0; u < kSize; ++u) {
            const bool is_joint = u % block_width == 0 || v % block_height == 0;
            const bool is_dark = (u / block_width + v / block_height) % 2 != 0;
            const int change = grain(u, v) - (is_joint ? 140 : is_dark ? 70 : 0);
            const Rgb8 colour{channel(light.red + change), channel(light.green + change), channel(light.blue + change)};
            texels.push_back(nearest_colour(palette, colour, kOrdinaryColours));
        }
    return make_mip_texture(name, kSize, kSize, std::move(texels), palette);
}

constexpr double kOnEdge_units = 1.0 / 256;

Point place_of(const map::BspFile& bsp, int vertex) {
    return map::to_point(item(bsp.vertices, vertex));
}

/// Whether a corner lies on the line from the one before to the next.
bool is_within_edge(const Point& before, const Point& corner, const Point& next) {
    const Point whole = next - before;
    return length(cross(whole, corner - before)) <= kOnEdge_units * length(whole);
}

std::vector<int> without_those_within_edges(const map::BspFile& bsp, const std::vector<int>& corners) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int before = kept.empty() ? corners.back() : kept.back(), next = corners[(i + 1) % corners.size()];
        if (!is_within_edge(place_of(bsp, before), place_of(bsp, corners[i]), place_of(bsp, next)))
            kept.push_back(corners[i]);
    }
    return kept;
}

}  // namespace

MapBrush make_solid(const std::vector<std::vector<Point>>& polygons, const Point& inside, const std::string& texture,
                    double units) {
    MapBrush brush;
    for (const auto& polygon : polygons) brush.sides.push_back(make_side(polygon, inside, texture, units));
    return brush;
}

MapBrush make_box(const map::Box& box, const std::string& texture, double units) {
    const auto& [low, high] = box;
    return extrude({{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, low.z, high.z, texture, units);
}

MapBrush make_wedge(const std::array<std::array<double, 2>, 3>& triangle, double height, const std::string& texture) {
    return extrude({triangle.begin(), triangle.end()}, 0, height, texture, 1);
}

MapBrush make_sphere(const Point& centre, const std::string& even_texture, const std::string& odd_texture) {
    MapBrush sphere;
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
        const Ring &upper = kRings[ring], &lower = kRings[ring + 1];
        const bool is_upper = upper.radius_64 < lower.radius_64;
        const Ring &wide = is_upper ? lower : upper, &narrow = is_upper ? upper : lower;
        for (std::size_t i = 0; i < kCorners; ++i) {
            // Both corners of the wider edge and one of the other, which is a point at a pole.
            const std::vector<Point> facet{ring_point(centre, wide, i), ring_point(centre, wide, (i + 1) % kCorners),
                                           ring_point(centre, narrow, i)};
            sphere.sides.push_back(make_side(facet, centre, (ring + i) % 2 == 0 ? even_texture : odd_texture, 1));
        }
    }
    return sphere;
}

SceneMap::SceneMap(const map::Box& room) {
    entities_.push_back({{{"classname", "worldspawn"}, {"light", "80"}}, {}});
    const Point low = room.mins, high = room.maxs, wall{kWall, kWall, kWall};
    const Point outer_low = low - wall, outer_high = high + wall;
    add(make_box({outer_low, {outer_high.x, outer_high.y, low.z}}, "tiles"));
    add(make_box({{outer_low.x, outer_low.y, high.z}, outer_high}, "tiles"));
    add(make_box({{outer_low.x, high.y, low.z}, {outer_high.x, outer_high.y, high.z}}, "stone"));
    add(make_box({{high.x, low.y, low.z}, {outer_high.x, high.y, high.z}}, "stone"));
    add(make_box({{outer_low.x, outer_low.y, low.z}, {outer_high.x, low.y, high.z}}, "stone"));
    add(make_box({{outer_low.x, low.y, low.z}, {low.x, high.y, high.z}}, "stone"));
}

void SceneMap::add_light(const Point& origin, int brightness, const std::string& colour) {
    add_point("light", origin, {{"light", std::to_string(brightness)}, {"wait", "1.5"}, {"_color", colour}});
}

void SceneMap::add_point(const std::string& classname, const Point& origin, std::vector<map::MapPair> more) {
    std::ostringstream place;
    place.precision(15);
    place << origin.x << ' ' << origin.y << ' ' << origin.z;
    more.insert(more.begin(), {{"classname", classname}, {"origin", place.str()}});
    entities_.push_back({std::move(more), {}});
}

std::string make_scene_wad(const Palette& palette) {
    const std::array<MipTexture, 2> textures{make_texture("stone", 16, 8, {200, 180, 150}, palette),
                                             make_texture("tiles", 8, 8, {150, 180, 200}, palette)};
    const std::vector<std::uint8_t> bytes = write_wad(textures);
    return {bytes.begin(), bytes.end()};
}

void loosen_edges(map::BspFile& bsp) {
    std::vector<std::array<int, 2>> edges{{0, 0}};  // edge 0 has no negative
    std::vector<int> surf_edges;
    for (map::FileFace& face : bsp.faces) {
        const std::vector<int> corners = without_those_within_edges(bsp, vertices_at(bsp, face));
        face.first_surf_edge = static_cast<int>(surf_edges.size());
        face.edge_count = static_cast<int>(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            surf_edges.push_back(static_cast<int>(edges.size()));
            edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
        }
    }
    bsp.edges = std::move(edges);
    bsp.surf_edges = std::move(surf_edges);
}

}  // namespace oblong
