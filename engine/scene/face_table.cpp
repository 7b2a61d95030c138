#include "engine/scene/face_table.h"

#include <algorithm>
#include <array>
#include <map>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"
#include "engine/level/t_junctions.h"

namespace oblong {

namespace {

/// Appends the corners of a face, with the T-junction vertices on its edges, in the face's winding.
void append_corners(const Level& level, const Face& face, std::span<const TJunction> junctions,
                    std::vector<VertexIndex>& corners) {
    for (const SurfEdge step : level.edges_of(face)) {
        const std::span<const TJunction> inside = junctions_on(junctions, step.edge());
        corners.push_back(level.start_of(step));
        for (const TJunction& each : inside) corners.push_back(each.vertex);
        if (step.is_reversed()) std::reverse(corners.end() - static_cast<std::ptrdiff_t>(inside.size()), corners.end());
    }
}

EffectSet effects_of(const TexInfo& texinfo, const std::string& texture) {
    if (texinfo.material == Material::Sky) return EffectSet{}.with(Effect::Sky);
    if (texinfo.material == Material::Liquid) return EffectSet{}.with(Effect::Liquid);
    if (texture.starts_with("mirror")) return EffectSet{}.with(Effect::Mirror);
    if (has_holes(texture)) return EffectSet{}.with(Effect::Fence);
    return {};
}

/// Texels per unit along the denser axis of each texinfo.
Table<StoredDensity, TexInfo> densities_of(const Table<TexInfo>& texinfos) {
    Table<StoredDensity, TexInfo> densities;
    densities.reserve(texinfos.size());
    for (const TexInfo& texinfo : texinfos)
        densities.push_back(convert<StoredDensity>(std::max(length(texinfo.s), length(texinfo.t)), Rounding::Floor));
    return densities;
}

/// The texture's axes map the face's plane to texels. The smallest stretch of this map is its change of area divided by
/// its greatest stretch, which is at most the root of the sum of both axes' squares.
StoredDensity least_density(const LevelPlane& plane, const TexInfo& texinfo) {
    using Coarse = Fixed<std::int32_t, 12>;
    using Area = Fixed<std::int64_t, 30>;
    const auto s = convert<Coarse>(texinfo.s), t = convert<Coarse>(texinfo.t);
    const auto across = convert<Coarse>(cross(s, t));
    const auto area = convert<Area>(absolute(dot(across, convert<Fixed<std::int32_t, 14>>(plane.normal))));
    const auto squares = (dot(s, s) + dot(t, t)).bits();
    const auto greatest = Fixed<std::int64_t, 12>::from_raw(static_cast<std::int64_t>(integer_root(squares)) + 2);
    return convert<StoredDensity>(bounded_quotient<TexelDensity>(area, greatest));
}

void add_face(const Level& level, const Face& face, std::span<const TJunction> junctions, StoredDensity density,
              FaceTable& table) {
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const std::size_t first = table.corners.size();
    append_corners(level, face, junctions, table.corners);
    const std::size_t count = table.corners.size() - first;
    table.faces.push_back({static_cast<std::uint32_t>(first), density, least_density(level.planes[face.plane], texinfo),
                           effects_of(texinfo, level.texture_of(face).name), static_cast<LevelNumber>(count),
                           texinfo.material, false});
    table.most_corners = std::max(table.most_corners, count);
}

/// Calls visit(from, to) for each edge of the faces in the world's nodes; other faces are never drawn.
template <class Visit>
void for_each_edge(const Level& level, const FaceTable& table, Visit visit) {
    const IndexRange<Face>& world = level.world().faces;
    for (const Node& node : level.nodes)
        for (const FaceIndex face : node.faces) {
            if (face < world.first || face.number() - world.first.number() >= world.count) continue;
            const std::span<const VertexIndex> corners = table.corners_of(face);
            VertexIndex from = corners.back();
            for (const VertexIndex to : corners) {
                visit(from, to);
                from = to;
            }
        }
}

std::uint64_t scrambled(std::uint64_t hash) {
    hash *= 0x9e3779b97f4a7c15;
    return hash ^ hash >> 29;
}

/// Two hashes of a vertex's position.
struct PlaceHash {
    std::uint64_t first, second;
};

Table<PlaceHash, Vertex> hashes_of_places(const Level& level) {
    Table<PlaceHash, Vertex> hashes;
    hashes.reserve(level.vertices.size());
    for (const Vec3<World>& p : level.vertices) {
        std::uint64_t hash = 0;
        for (const World part : {p.x, p.y, p.z}) hash = scrambled(hash ^ part.bits());
        hashes.push_back({hash, scrambled(~hash)});
    }
    return hashes;
}

/// Whether each edge is used as often in one direction as in the other: then the sum cancels. In one of 2^56 other
/// levels it cancels by chance.
bool is_closed(const Level& level, const FaceTable& table) {
    const Table<PlaceHash, Vertex> hashes = hashes_of_places(level);
    std::uint64_t sum = 0;
    for_each_edge(level, table, [&](VertexIndex from, VertexIndex to) {
        const PlaceHash &a = hashes[from], &b = hashes[to];
        sum += a.first * b.second - b.first * a.second;
    });
    return sum == 0;
}

/// Counts the edges that are used more often in one direction than in the other.
std::size_t count_torn_edges(const Level& level, const FaceTable& table) {
    if (is_closed(level, table)) return 0;
    const auto place = [&](VertexIndex vertex) {
        const Vec3<World>& p = level.vertices[vertex];
        return std::array{p.x, p.y, p.z};
    };
    std::map<std::pair<std::array<World, 3>, std::array<World, 3>>, std::int32_t> balance;
    for_each_edge(level, table, [&](VertexIndex from, VertexIndex to) {
        if (place(from) < place(to))
            ++balance[{place(from), place(to)}];
        else
            --balance[{place(to), place(from)}];
    });
    return as_size(std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

}  // namespace

FaceTable make_face_table(const Level& level) {
    FaceTable table;
    const std::vector<TJunction> junctions = level.t_junctions ? *level.t_junctions : find_t_junctions(level);
    const Table<StoredDensity, TexInfo> densities = densities_of(level.texinfos);
    table.faces.reserve(level.faces.size());
    std::size_t corner_count = 0;
    for (const Face& face : level.faces)
        for (const SurfEdge step : level.edges_of(face))
            corner_count += 1 + junctions_on(junctions, step.edge()).size();
    table.corners.reserve(corner_count);
    for (const Face& face : level.faces) add_face(level, face, junctions, densities[face.texinfo], table);
    table.torn_edges = count_torn_edges(level, table);
    return table;
}

}  // namespace oblong
