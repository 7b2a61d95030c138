#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// A part of a brush model's face that lies in one leaf of the world.
struct Fragment {
    FaceIndex face;
    LeafIndex leaf;
    PlacedIndex placed;
    std::uint32_t first_corner = 0, corner_count = 0;
    Index<struct FragmentTree> tree =
        Index<FragmentTree>::none();  ///< holds its corners; none: they are in the ModelCut
};

/// Which side of a plane a polygon is on. Corners within 1/1,024 unit count as on it, so that no piece is thinner.
enum class PolygonSide : std::uint8_t { On, Front, Back, Both };

/// The side of a plane, moved by `offset`, that a polygon is on. Sets `distances` of the corners, 0 for those on it.
PolygonSide polygon_side(const LevelPlane& plane, const Vec3<World>& offset, std::span<const Vec3<World>> polygon,
                         std::vector<PlaneDistance>& distances);

/// Appends to `corners` the part on one side of a plane of the polygon that begins at `first` in `corners` and has
/// these `distances` from the plane. Both parts get the same corners on the plane.
void append_part(std::vector<Vec3<World>>& corners, std::uint32_t first, std::span<const PlaneDistance> distances,
                 bool in_front);

/// All parts of one placed model.
struct ModelCut {
    std::vector<Fragment> fragments;
    std::vector<Vec3<World>> corners;
};

/// Cuts a model's faces by the planes of the world's tree, down to its leaves; parts in solid are left out. Its
/// fragments get the index `placed`.
ModelCut cut_model(const Level& level, const PlacedModel& model, PlacedIndex placed, const FaceTable& table);

/// A BSP tree of the parts of several brush models in one leaf: it orders them from every eye, even where models
/// intersect (Fuchs, Kedem and Naylor 1980).
struct FragmentTree {
    struct Node {
        std::vector<Index<Fragment>> on_plane;  ///< the node's plane is that of the first
        Index<Node> front = Index<Node>::none(), back = Index<Node>::none();
    };
    Table<Fragment> fragments;
    std::vector<Vec3<World>> corners;
    Table<Node> nodes;
    Index<Node> root = Index<Node>::none();
};

/// With more parts the tree stays empty, and none is cut: a tree of n parts takes n^2 steps.
inline constexpr std::size_t kMostFragmentsInTree = 256;

/// The tree of fragments, whose corners lie in `corners`. `models` are the scene's.
FragmentTree build_fragment_tree(const Level& level, const Table<PlacedModel>& models, Table<Fragment> fragments,
                                 std::vector<Vec3<World>> corners);

}  // namespace oblong
