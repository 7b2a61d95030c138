#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/visibility/model_cutter.h"

namespace oblong {

/// The parts of several brush models in one leaf, cut by each other's planes: they have an order from every eye, also
/// where models reach into each other (Fuchs, Kedem and Naylor 1980).
struct FragmentTree {
    struct Node {
        std::vector<Index<Fragment>> on_plane;  ///< the first's plane is the node's
        Index<Node> front = Index<Node>::none(), back = Index<Node>::none();
    };
    Table<Fragment> fragments;
    std::vector<Vec3<World>> corners;
    Table<Node> nodes;
    Index<Node> root = Index<Node>::none();
};

/// With more parts than this none are cut and the tree is empty: a tree of n parts takes n^2 steps.
inline constexpr std::size_t kMostFragmentsInTree = 256;

/// The tree of fragments, whose corners lie in `corners`. `models` are the scene's.
FragmentTree build_fragment_tree(const Level& level, const Table<PlacedModel>& models, Table<Fragment> fragments,
                                 std::vector<Vec3<World>> corners);

}  // namespace oblong
