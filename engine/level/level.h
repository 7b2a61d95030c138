#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// What fills a leaf (Quake's numbers).
namespace contents {
inline constexpr std::int32_t kEmpty = -1, kSolid = -2, kWater = -3, kSlime = -4, kLava = -5, kSky = -6;
}

/// normal . p = distance. The float normal and distance of the file, exact: `normal` (2.30) holds it to 2^-30, and
/// `normal_rest` the rest in units of 2^-60; the same for the distance: 2^-42 and 2^-72. See plane_side()
/// (level/side.h).
struct LevelPlane {
    Vec3<Unit> normal;
    PlaneDistance distance;
    std::array<std::int32_t, 3> normal_rest_60{};
    std::int32_t distance_rest_72 = 0;
    std::uint8_t axis = 3;  ///< 0, 1, 2: the normal is exactly +x, +y, +z; 3: any other

    bool operator==(const LevelPlane&) const = default;
};

/// An axis-aligned box in whole world units, rounded outward.
struct LevelBox {
    std::array<std::int32_t, 3> mins{}, maxs{};

    bool operator==(const LevelBox&) const = default;
};

/// How a texture lies on faces: u = s . p + s_offset, v = t . p + t_offset, in texels of mip level 0.
struct TexInfo {
    Vec3<TexelAxis> s, t;
    Texel s_offset, t_offset;
    std::int32_t miptex = 0;  ///< index into Level::textures; always valid
    bool is_special = false;  ///< sky or liquid: no lightmap, no limit of extent

    bool operator==(const TexInfo&) const = default;
};

/// A convex polygon on a plane. Its vertices run clockwise seen from the side that it faces.
struct Face {
    std::int32_t plane = 0;
    bool is_back = false;  ///< faces the plane's back
    std::int32_t first_surfedge = 0, edge_count = 0;
    std::int32_t texinfo = 0;
    std::array<std::uint8_t, 4> styles{};  ///< light styles, 255: none
    std::int32_t light_offset =
        -1;  ///< into Level::lighting; -1: no lightmap (special faces; others are then full dark)
    std::int32_t texel_min_u = 0, texel_min_v = 0;  ///< multiples of 16; rounded outward, as the light compilers do
    std::int32_t texel_extent_u = 0, texel_extent_v = 0;  ///< multiples of 16; a lightmap has extent / 16 + 1 samples

    bool operator==(const Face&) const = default;
};

/// Children: an index of a node, or -1 - an index of a leaf. [0] is the plane's front (normal . p > distance).
struct Node {
    std::int32_t plane = 0;
    std::array<std::int32_t, 2> children{};
    LevelBox box;
    std::int32_t first_face = 0, face_count = 0;

    bool operator==(const Node&) const = default;
};

struct Leaf {
    std::int32_t contents = contents::kEmpty;
    std::int32_t visibility_offset = -1;  ///< into Level::visibility, run-length packed; -1: everything is visible
    LevelBox box;
    std::int32_t first_mark_face = 0, mark_face_count = 0;  ///< into Level::mark_faces

    bool operator==(const Leaf&) const = default;
};

/// Children: an index of a clipnode, or contents (negative).
struct ClipNode {
    std::int32_t plane = 0;
    std::array<std::int32_t, 2> children{};

    bool operator==(const ClipNode&) const = default;
};

/// A brush model: 0 is the world, the others are doors, lifts and the like.
struct SubModel {
    LevelBox box;  ///< of all its brushes: the file's is a unit smaller on each side
    Vec3<World> origin;
    std::array<std::int32_t, 4> head_nodes{};  ///< [0] into nodes (or -1 - leaf), [1..3] into clip_nodes (or contents)
    std::int32_t visible_leaf_count = 0;
    std::int32_t first_face = 0, face_count = 0;

    bool operator==(const SubModel&) const = default;
};

/// A texture with four mip levels, each half the size of the one before; rows top to bottom, one palette index a texel.
struct MipTexture {
    std::string name;
    std::int32_t width = 0, height = 0;  ///< of mip level 0; multiples of 16
    std::array<std::vector<std::uint8_t>, 4> mips;
    bool is_missing = false;  ///< the file has no texels for it: the reader made a checkerboard

    bool operator==(const MipTexture&) const = default;
};

struct EdgeIndices {
    std::int32_t from = 0, to = 0;  ///< vertices

    bool operator==(const EdgeIndices&) const = default;
};

/// One entity: the key/value pairs as written, in order.
struct Entity {
    std::vector<std::pair<std::string, std::string>> pairs;

    /// The value of the first pair named `key`, or `otherwise`.
    std::string value(const std::string& key, const std::string& otherwise = "") const;

    bool operator==(const Entity&) const = default;
};

/// A level in the engine's units, checked: every index in it is in range, every tree ends, every number fits its
/// format.
struct Level {
    std::vector<Entity> entities;
    std::vector<LevelPlane> planes;
    std::vector<MipTexture> textures;
    std::vector<Vec3<World>> vertices;
    std::vector<std::uint8_t> visibility;
    std::vector<Node> nodes;
    std::vector<TexInfo> texinfos;
    std::vector<Face> faces;
    std::vector<std::uint8_t> lighting;
    std::vector<ClipNode> clip_nodes;
    std::vector<Leaf> leaves;  ///< [0] is the solid outside
    std::vector<std::int32_t> mark_faces;
    std::vector<EdgeIndices> edges;
    std::vector<std::int32_t> surf_edges;  ///< e >= 0: edge e from -> to; e < 0: edge -e to -> from
    std::vector<SubModel> models;          ///< at least one

    bool operator==(const Level&) const = default;
};

}  // namespace oblong
