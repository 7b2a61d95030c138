#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

struct LevelPlane;
struct MipTexture;
struct TexInfo;
struct Face;
struct Node;
struct Leaf;
struct ClipNode;
struct SubModel;
struct Edge;
class SurfEdge;
struct Vertex;    // a Vec3<World> of Level::vertices
struct MarkFace;  // a FaceIndex of Level::mark_faces

template <>
struct StoredIndex<SurfEdge> {
    using Number = std::int32_t;
};

using PlaneIndex = Index<LevelPlane>;
using TextureIndex = Index<MipTexture>;
using TexInfoIndex = Index<TexInfo>;
using FaceIndex = Index<Face>;
using NodeIndex = Index<Node>;
using LeafIndex = Index<Leaf>;
using ClipNodeIndex = Index<ClipNode>;
using ModelIndex = Index<SubModel>;
using EdgeIndex = Index<Edge>;
using VertexIndex = Index<Vertex>;

inline constexpr LeafIndex kSolidOutside{0};
inline constexpr ModelIndex kWorldModel{0};

/// The contents of a leaf (Quake's numbers).
namespace contents {
inline constexpr std::int32_t kEmpty = -1, kSolid = -2, kWater = -3, kSlime = -4, kLava = -5, kSky = -6;
}

/// normal . p = distance. The file's floats are stored exactly: `normal` to 2^-30 and the rest in `normal_rest_60` in
/// units of 2^-60; the distance in units of 2^-42 and 2^-72. See plane_side() (level/side.h).
struct LevelPlane {
    Vec3<Unit> normal;
#ifdef OBLONG_SMALL_MEMORY  // only levels without rests
    static constexpr std::array<std::int32_t, 3> normal_rest_60{};
    static constexpr std::int32_t distance_rest_72 = 0;
    PlaneDistance distance;
#else
    std::array<std::int32_t, 3> normal_rest_60{};
    PlaneDistance distance;
    std::int32_t distance_rest_72 = 0;
#endif
    std::uint8_t axis = 3;  ///< 0, 1, 2: the normal is exactly +x, +y, +z; 3: other

    bool operator==(const LevelPlane&) const = default;
};

/// An axis-aligned box in whole world units, rounded outward.
struct LevelBox {
    std::array<LevelNumber, 3> mins{}, maxs{};

    bool operator==(const LevelBox&) const = default;
};

/// A coordinate of a box, clamped to the world, so that a box's middle fits World, and to what a box can store.
constexpr LevelNumber box_coordinate(std::int64_t units) {
    constexpr std::int64_t kFarthest = std::min<std::int64_t>((1 << 19) - 1, std::numeric_limits<LevelNumber>::max());
    return static_cast<LevelNumber>(std::clamp(units, -kFarthest, kFarthest));
}

constexpr Vec3<World> middle_of(const LevelBox& box) {
    const auto middle = [&](std::size_t axis) { return World::from_raw((box.mins[axis] + box.maxs[axis]) * 2048); };
    return {middle(0), middle(1), middle(2)};
}

/// How a face is drawn. Only lit faces have a lightmap and a limited extent; unlit ones show their texture as it is.
enum class Material : std::uint8_t { Lit, Liquid, Sky, Unlit };

constexpr Material material_of_texture(std::string_view name) {
    return name.starts_with('*') ? Material::Liquid : name.starts_with("sky") ? Material::Sky : Material::Lit;
}

/// A texture mapping: u = s . p + s_offset, v = t . p + t_offset, in texels of mip level 0.
struct TexInfo {
    Vec3<TexelAxis> s, t;
    Texel s_offset, t_offset;
    TextureIndex texture;
    Material material = Material::Lit;  ///< by the texture's name; Unlit if that says Lit, but the file flags faces as
                                        ///< unlit and has no light for them

    bool operator==(const TexInfo&) const = default;
};

/// Ends a list of light styles.
inline constexpr std::uint8_t kNoStyle = 255;

/// A convex polygon on a plane, with clockwise vertices seen from its front.
struct Face {
    PlaneIndex plane;
    bool is_back = false;  ///< faces the plane's back
    IndexRange<SurfEdge> edges;
    TexInfoIndex texinfo;
    std::array<std::uint8_t, 4> styles{};  ///< light styles, ended by kNoStyle
    std::int32_t light_offset = -1;        ///< in Level::lighting; -1: no lightmap (special faces; others are black)
    LevelNumber texel_min_u = 0, texel_min_v = 0;        ///< multiples of 16, rounded outward as in light compilers
    LevelNumber texel_extent_u = 0, texel_extent_v = 0;  ///< multiples of 16

    /// Light samples along u and v: one every 16 texels.
    constexpr std::int32_t sample_columns() const { return texel_extent_u / 16 + 1; }
    constexpr std::int32_t sample_rows() const { return texel_extent_v / 16 + 1; }
    /// The styles before kNoStyle; a lit face has one lightmap for each.
    std::span<const std::uint8_t> used_styles() const {
        return {styles.begin(), std::find(styles.begin(), styles.end(), kNoStyle)};
    }
    bool operator==(const Face&) const = default;
};

/// A child of a node: another node or a leaf.
class NodeChild {
  public:
    constexpr NodeChild() = default;
    constexpr explicit NodeChild(NodeIndex node) : number_(static_cast<LevelNumber>(node.number())) {}
    constexpr explicit NodeChild(LeafIndex leaf) : number_(static_cast<LevelNumber>(-1 - leaf.number())) {}

    constexpr bool is_leaf() const { return number_ < 0; }
    constexpr LeafIndex leaf() const { return LeafIndex(-1 - number_); }
    constexpr NodeIndex node() const { return NodeIndex(number_); }
    constexpr bool operator==(const NodeChild&) const = default;

  private:
    LevelNumber number_ = 0;  ///< as in the file: of a node, or -1 minus that of a leaf
};

/// children[0] is in front of the plane (normal . p > distance).
struct Node {
    PlaneIndex plane;
    std::array<NodeChild, 2> children{};
    LevelBox box;
    IndexRange<Face> faces;  ///< on its plane

    bool operator==(const Node&) const = default;
};

struct Leaf {
    LevelNumber contents = contents::kEmpty;
    std::int32_t visibility_offset = -1;  ///< in Level::visibility, run-length packed; -1: everything is visible
    LevelBox box;
    IndexRange<MarkFace> mark_faces;  ///< faces that border it

    /// Neither solid nor sky.
    constexpr bool is_open() const { return contents != contents::kSolid && contents != contents::kSky; }
    bool operator==(const Leaf&) const = default;
};

/// A child of a clipnode: another clipnode or contents.
class ClipChild {
  public:
    constexpr ClipChild() = default;
    constexpr explicit ClipChild(ClipNodeIndex node) : number_(static_cast<LevelNumber>(node.number())) {}
    constexpr explicit ClipChild(std::int32_t contents) : number_(static_cast<LevelNumber>(contents)) {}

    constexpr bool is_leaf() const { return number_ < 0; }
    constexpr std::int32_t contents() const { return number_; }
    constexpr ClipNodeIndex node() const { return ClipNodeIndex(number_); }
    constexpr bool operator==(const ClipChild&) const = default;

  private:
    LevelNumber number_ = contents::kEmpty;  ///< as in the file: contents are negative
};

/// A node of a tree in which a body is a point (level/trace.h).
struct ClipNode {
    PlaneIndex plane;
    std::array<ClipChild, 2> children{};

    bool operator==(const ClipNode&) const = default;
};

/// A brush model: 0 is the world, the others are doors, lifts and the like.
struct SubModel {
    LevelBox box;  ///< of all its brushes; in the file it is a unit smaller on each side
    Vec3<World> origin;
    NodeChild root;
    std::array<ClipChild, 3> clip_roots{};
    LevelNumber visible_leaf_count = 0;
    IndexRange<Face> faces;

    bool operator==(const SubModel&) const = default;
};

/// A texture with four mip levels, each half the size of the previous; rows top to bottom, one palette index a texel.
struct MipTexture {
    std::string name;
    std::int32_t width = 0, height = 0;  ///< of mip level 0; multiples of 16
    std::array<std::vector<std::uint8_t>, 4> mips;
    bool is_missing = false;  ///< the file has no texels that can be drawn; the reader made a checkerboard

    bool operator==(const MipTexture&) const = default;
};

/// By the name of a texture: texels of the last colour are holes, which let light and views through.
constexpr bool has_holes(std::string_view texture_name) {
    return texture_name.starts_with('{');
}

struct Edge {
    VertexIndex from, to;

    bool operator==(const Edge&) const = default;
};

/// A vertex inside an edge (level/t_junctions.h).
struct TJunction {
    EdgeIndex edge;
    VertexIndex vertex;

    bool operator==(const TJunction&) const = default;
};

/// An edge in the direction in which a face uses it.
class SurfEdge {
  public:
    constexpr SurfEdge() = default;
    constexpr SurfEdge(EdgeIndex edge, bool is_reversed)
        : number_(static_cast<LevelNumber>(is_reversed ? -1 - edge.number() : edge.number())) {}

    constexpr EdgeIndex edge() const { return EdgeIndex(is_reversed() ? -1 - number_ : number_); }
    /// Whether it goes from `to` to `from`.
    constexpr bool is_reversed() const { return number_ < 0; }
    constexpr bool operator==(const SurfEdge&) const = default;

  private:
    LevelNumber number_ = 0;  ///< of the edge, or -1 minus that
};

/// An entity's key/value pairs, in the file's order.
struct Entity {
    std::vector<std::pair<std::string, std::string>> pairs;

    /// The value of the first pair named `key`, or `otherwise`.
    std::string value(const std::string& key, const std::string& otherwise = "") const;

    bool operator==(const Entity&) const = default;
};

/// A checked level in the engine's units: all indices are in range, trees have no cycles, numbers fit their formats.
struct Level {
    std::vector<Entity> entities;
    Table<LevelPlane> planes;
    Table<MipTexture> textures;
    Table<Vec3<World>, Vertex> vertices;
    std::vector<std::uint8_t> visibility;
    Table<Node> nodes;
    Table<TexInfo> texinfos;
    Table<Face> faces;
    std::vector<std::uint8_t> lighting;
    std::vector<std::uint8_t> coloured_lighting;  ///< red, green and blue of each value of `lighting`; empty: all white
    Table<ClipNode> clip_nodes;
    Table<Leaf> leaves;  ///< the first is the solid outside
    Table<FaceIndex, MarkFace> mark_faces;
    Table<Edge> edges;
    Table<SurfEdge> surf_edges;
    Table<SubModel> models;                   ///< at least one
    TextureIndex sky = TextureIndex::none();  ///< the first sky texture
    /// If the level was prepared with them; else find_t_junctions() does it.
    std::optional<std::vector<TJunction>> t_junctions;

    const SubModel& world() const { return models.front(); }
    /// The leaves in visible sets: the world's, without the solid outside.
    IndexRange<Leaf> visible_leaves() const { return {LeafIndex(1), world().visible_leaf_count}; }
    const MipTexture& texture_of(const Face& face) const { return textures[texinfos[face.texinfo].texture]; }
    std::span<const FaceIndex> faces_at(const Leaf& leaf) const { return mark_faces[leaf.mark_faces]; }
    std::span<const SurfEdge> edges_of(const Face& face) const { return surf_edges[face.edges]; }
    /// The vertex at which a surfedge starts.
    VertexIndex start_of(SurfEdge step) const {
        return step.is_reversed() ? edges[step.edge()].to : edges[step.edge()].from;
    }

    bool operator==(const Level&) const = default;
};

// In pvs.cpp.

/// Bytes of a set of the world's leaves: one bit each, without leaf 0 (the solid outside).
std::size_t visible_set_size(const Level& level);

/// Writes the potentially visible set of `leaf` to `visible`, which must have visible_set_size() bytes. All leaves for
/// the solid outside and for leaves without a set.
void unpack_visible_set(const Level& level, LeafIndex leaf, std::span<std::uint8_t> visible);

/// False for the solid outside and for leaves of brush models.
inline bool is_in_set(std::span<const std::uint8_t> visible, LeafIndex leaf) {
    const std::size_t bit = leaf.position() - 1;
    return leaf > kSolidOutside && bit / 8 < visible.size() && (visible[bit / 8] >> bit % 8 & 1) != 0;
}

}  // namespace oblong
