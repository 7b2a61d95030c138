#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "engine/level/bsp_file.h"

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

namespace {

constexpr std::int32_t kAxisLimit = 255;        ///< texels a unit: TexelAxis holds 256, so there is room for rounding
constexpr std::int32_t kOffsetLimit = 1 << 30;  ///< texels: plus the axes' part (below 2^29) it fits 32 bits
constexpr std::int64_t kTexInfoSize = 40;       ///< bytes

TexelAxis read_axis_part(LumpReader& in) {
    return TexelAxis::from_raw(
        static_cast<std::int32_t>(in.read_fixed(TexelAxis::kFractionBits, kAxisLimit, "component of a texture axis")));
}

Vec3<TexelAxis> read_axis(LumpReader& in) {
    const TexelAxis x = read_axis_part(in), y = read_axis_part(in), z = read_axis_part(in);
    return {x, y, z};
}

Texel read_texel_offset(LumpReader& in) {
    return Texel::from_raw(in.read_fixed(Texel::kFractionBits, kOffsetLimit, "texture offset"));
}

std::array<FloatBits, 4> read_axis_floats(LumpReader& in) {
    std::array<FloatBits, 4> axis;
    for (FloatBits& part : axis) part = in.read_float();
    return axis;
}

/// The floats of a face's corners, in order.
void gather_polygon(const Level& level, const Face& face, const Table<FloatBits3, Vertex>& vertex_floats,
                    std::vector<FloatBits3>& polygon) {
    polygon.clear();
    for (const SurfEdge edge : level.edges_of(face)) polygon.push_back(vertex_floats[level.start_of(edge)]);
}

/// How a face's corners turn, seen from the tip of an axis: above 0 counter-clockwise, below 0 clockwise. 0 if rounded
/// to quarters of a unit they are all about on a line.
std::int64_t turn_seen_along(int axis, const Level& level, const Face& face) {
    using Part = World Vec3<World>::*;
    constexpr std::array<Part, 3> kRight{&Vec3<World>::y, &Vec3<World>::z, &Vec3<World>::x},
        kUp{&Vec3<World>::z, &Vec3<World>::x, &Vec3<World>::y};
    const Part right = item(kRight, axis), up = item(kUp, axis);
    const auto corner = [&](SurfEdge edge) {
        const Vec3<World>& at = level.vertices[level.start_of(edge)];
        return std::pair<std::int64_t, std::int64_t>{floor_of<2>(at.*right), floor_of<2>(at.*up)};
    };
    const std::span<const SurfEdge> edges = level.edges_of(face);
    const auto first = corner(edges[0]);
    for (std::size_t i = 2; i < edges.size(); ++i) {
        const auto second = corner(edges[i - 1]), third = corner(edges[i]);
        const std::int64_t x1 = second.first - first.first, y1 = second.second - first.second,
                           x2 = third.first - first.first, y2 = third.second - first.second;
        const std::int64_t area = x1 * y2 - x2 * y1;
        if (std::abs(area) > 2 * (std::abs(x1) + std::abs(y1) + std::abs(x2) + std::abs(y2) + 2)) return area;
    }
    return 0;
}

/// Of compilers, real levels' corners are up to 0.013 units from their planes.
constexpr PlaneDistance kFarthestFromPlane = PlaneDistance::from_int(1);

/// Throws unless the corners are on the face's plane, and clockwise seen from its front: else it would be drawn
/// wrongly, or not at all. Compilers make faces too narrow to tell.
void check_corners(const LumpReader& in, const Level& level, const Face& face) {
    const LevelPlane& plane = level.planes[face.plane];
    for (const SurfEdge edge : level.edges_of(face)) {
        const PlaneDistance off = dot(level.vertices[level.start_of(edge)], plane.normal) - plane.distance;
        if (off > kFarthestFromPlane || off < -kFarthestFromPlane)
            in.fail("a corner " + std::to_string(floor_of<0>(off < PlaneDistance{} ? -off : off)) +
                    " units off the face's plane, expected 1 at most");
    }
    const std::array<Unit, 3> normal{plane.normal.x, plane.normal.y, plane.normal.z};
    const auto nearest =
        std::max_element(normal.begin(), normal.end(), [](Unit a, Unit b) { return magnitude(a) < magnitude(b); });
    const std::int64_t turn = turn_seen_along(static_cast<int>(nearest - normal.begin()), level, face);
    const bool is_from_front = (*nearest > Unit{}) != face.is_back;
    if (is_from_front ? turn > 0 : turn < 0)
        in.fail("corners counter-clockwise seen from the face's front, expected clockwise");
}

Face read_face(LumpReader& in, const BspFile& file, const Level& level) {
    Face face;
    face.plane = check_index<LevelPlane>(in, in.read_index(), file, Lump::Planes, "plane");
    face.is_back = in.read_index() != 0;
    const std::int32_t first_edge = in.read_i32(), edge_count = in.read_index();
    if (edge_count < 3) in.fail(std::to_string(edge_count) + " edges, expected 3 or more");
    face.edges = in.check_range<SurfEdge>(first_edge, edge_count, file.count(Lump::SurfEdges), "surfedges");
    check_corners(in, level, face);
    face.texinfo = check_index<TexInfo>(in, in.read_index(), file, Lump::TexInfos, "texinfo");
    for (std::uint8_t& style : face.styles) style = in.read_u8();
    face.light_offset = in.read_i32();
    return face;
}

std::int64_t lightmaps_size(const Face& face) {
    return std::ssize(face.used_styles()) * face.sample_columns() * face.sample_rows();
}

bool is_too_large_for_light(const Face& face) {
    return face.texel_extent_u > kMaxLitExtent || face.texel_extent_v > kMaxLitExtent;
}

/// Sky, liquids and all faces of a level without lighting get no lightmap, whatever their offset. The extent of lit
/// faces is limited in any case, as frames cache their surfaces.
void check_light(const LumpReader& in, const BspFile& file, Material material, Face& face) {
    const bool may_be_lit = material == Material::Lit || material == Material::Unlit;
    if (!may_be_lit || file.count(Lump::Lighting) == 0) face.light_offset = -1;
    if (!may_be_lit) return;
    if (is_too_large_for_light(face) && material == Material::Unlit) return;
    if (is_too_large_for_light(face))
        in.fail("a lit face of " + std::to_string(face.texel_extent_u) + "x" + std::to_string(face.texel_extent_v) +
                " texels, expected 2000 a side at most");
    if (face.light_offset == -1) return;
    in.check_extent(face.light_offset, lightmaps_size(face), file.count(Lump::Lighting), "light samples");
}

}  // namespace

Table<TexInfo> read_texinfos(const BspFile& file, const Level& level) {
    return read_records<Table<TexInfo>>(file, Lump::TexInfos, [&level](LumpReader& in) {
        TexInfo texinfo;
        texinfo.s = read_axis(in);
        texinfo.s_offset = read_texel_offset(in);
        texinfo.t = read_axis(in);
        texinfo.t_offset = read_texel_offset(in);
        texinfo.texture = TextureIndex(in.check_index(in.read_i32(), level.textures.count(), "texture"));
        const bool is_unlit = (in.read_u32() & kTexInfoSpecial) != 0;
        texinfo.material = material_of_texture(level.textures[texinfo.texture].name);
        if (is_unlit && texinfo.material == Material::Lit) texinfo.material = Material::Unlit;
        return texinfo;
    });
}

Table<Face> read_faces(const BspFile& file, const Level& level, const Table<FloatBits3, Vertex>& vertex_floats) {
    LumpReader axes(file, Lump::TexInfos);
    std::vector<FloatBits3> polygon;
    // Faces share surfedges only in files made to waste time.
    std::int64_t work_left = std::int64_t{file.count(Lump::SurfEdges)} * 8;
    return read_records<Table<Face>>(file, Lump::Faces, [&](LumpReader& in) {
        Face face = read_face(in, file, level);
        work_left -= face.edges.count;
        if (work_left < 0) in.fail("faces share surfedges, expected each to have its own");
        gather_polygon(level, face, vertex_floats, polygon);
        axes.seek(face.texinfo.number() * kTexInfoSize);
        const TexelRange u = texel_range(polygon, read_axis_floats(axes));
        const TexelRange v = texel_range(polygon, read_axis_floats(axes));
        face.texel_min_u = u.min;
        face.texel_min_v = v.min;
        face.texel_extent_u = u.extent;
        face.texel_extent_v = v.extent;
        check_light(in, file, level.texinfos[face.texinfo].material, face);
        return face;
    });
}

void light_flagged_faces(Level& level) {
    Table<std::uint8_t, TexInfo> is_lit(level.texinfos.size()), is_too_large(level.texinfos.size());
    for (const Face& face : level.faces) {
        if (face.light_offset >= 0) is_lit[face.texinfo] = 1;
        if (is_too_large_for_light(face)) is_too_large[face.texinfo] = 1;
    }
    for (const auto texinfo : level.texinfos.indices())
        if (level.texinfos[texinfo].material == Material::Unlit && is_lit[texinfo] && !is_too_large[texinfo])
            level.texinfos[texinfo].material = Material::Lit;
    for (Face& face : level.faces)
        if (level.texinfos[face.texinfo].material == Material::Unlit) face.light_offset = -1;
}

}  // namespace oblong
