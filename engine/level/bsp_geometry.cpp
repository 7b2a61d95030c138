#include <tuple>
#include <utility>

#include "engine/level/bsp_parts.h"

namespace oblong {

namespace {

constexpr std::int32_t kWorldLimit = 1 << 19;                ///< units: the limit of World
constexpr std::int32_t kDistanceLimit = 1 << 20;             ///< units: the world's corner is at 0.87 of it
constexpr std::int32_t kComponentLimit = 2;                  ///< the limit of Unit
constexpr std::int64_t kUnitSquare = std::int64_t{1} << 30;  ///< 1 in the format of squared_length_30

using NormalPart = std::pair<Unit, std::int32_t>;  ///< 2.30, and the rest in units of 2^-60

NormalPart read_normal_part(LumpReader& in) {
    const FloatBits value = in.read_float();
    const std::int64_t part = in.check_fixed(value, Unit::kFractionBits, kComponentLimit, "component of the normal");
    return {Unit::from_raw(static_cast<std::int32_t>(part)), rest_of_fixed(value, Unit::kFractionBits)};
}

std::int64_t squared_length_30(const Vec3<Unit>& v) {
    const auto square = [](Unit part) { return floor_of<30>(widening_product(part, part)); };
    return square(v.x) + square(v.y) + square(v.z);
}

/// plane_side() (level/side.h) has head-room only for normals of about length 1.
void check_unit_length(const LumpReader& in, const Vec3<Unit>& normal) {
    const std::int64_t difference = squared_length_30(normal) - kUnitSquare;
    if (difference < -kUnitSquare / 16 || difference > kUnitSquare / 16)
        in.fail("the normal's length is not 1, expected a difference of 3 % at most");
}

std::uint8_t axis_of(const LevelPlane& plane) {
    const std::array<Unit, 3> normal = {plane.normal.x, plane.normal.y, plane.normal.z};
    const std::array<std::int32_t, 3>& rest = plane.normal_rest_60;
    for (std::uint8_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1u) % 3, k = (i + 2u) % 3;
        const bool is_axis = normal[i] == Unit::from_int(1) && rest[i] == 0;
        if (is_axis && normal[j] == Unit{} && rest[j] == 0 && normal[k] == Unit{} && rest[k] == 0) return i;
    }
    return 3;
}

LevelPlane read_plane(LumpReader& in) {
    LevelPlane plane;
    std::tie(plane.normal.x, plane.normal_rest_60[0]) = read_normal_part(in);
    std::tie(plane.normal.y, plane.normal_rest_60[1]) = read_normal_part(in);
    std::tie(plane.normal.z, plane.normal_rest_60[2]) = read_normal_part(in);
    check_unit_length(in, plane.normal);

    const FloatBits distance = in.read_float();
    constexpr int kBits = PlaneDistance::kFractionBits;
    plane.distance = PlaneDistance::from_raw(in.check_fixed(distance, kBits, kDistanceLimit, "distance"));
    plane.distance_rest_72 = rest_of_fixed(distance, kBits);
    in.skip(4);  // the type; axis_of() uses the normal
    plane.axis = axis_of(plane);
    return plane;
}

}  // namespace

Table<LevelPlane> read_planes(const BspFile& file) {
    return read_records<Table<LevelPlane>>(file, Lump::Planes, read_plane);
}

Table<FloatBits3, Vertex> read_vertex_floats(const BspFile& file) {
    return read_records<Table<FloatBits3, Vertex>>(file, Lump::Vertices, [](LumpReader& in) {
        FloatBits3 vertex;
        for (FloatBits& part : vertex) part = in.read_float();
        return vertex;
    });
}

Vec3<World> read_world_vector(LumpReader& in) {
    const auto read_part = [&in] {
        const std::int64_t part = in.read_fixed(World::kFractionBits, kWorldLimit, "coordinate");
        return World::from_raw(static_cast<std::int32_t>(part));
    };
    const World x = read_part(), y = read_part(), z = read_part();
    return {x, y, z};
}

Table<Vec3<World>, Vertex> read_vertices(const BspFile& file) {
    return read_records<Table<Vec3<World>, Vertex>>(file, Lump::Vertices, read_world_vector);
}

Table<Edge> read_edges(const BspFile& file) {
    return read_records<Table<Edge>>(file, Lump::Edges, [&file](LumpReader& in) {
        const auto read_end = [&] { return check_index<Vertex>(in, in.read_index(), file, Lump::Vertices, "vertex"); };
        const VertexIndex from = read_end();
        return Edge{from, read_end()};
    });
}

Table<SurfEdge> read_surf_edges(const BspFile& file) {
    return read_records<Table<SurfEdge>>(file, Lump::SurfEdges, [&file](LumpReader& in) {
        const std::int64_t number = in.read_i32(), edge = number < 0 ? -number : number;
        if (edge >= file.count(Lump::Edges)) in.fail(describe_bad_index("edge", edge, file.count(Lump::Edges)));
        return SurfEdge{EdgeIndex(static_cast<std::int32_t>(edge)), number < 0};
    });
}

}  // namespace oblong
