#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/visibility/model_cutter.h"

namespace oblong {

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
