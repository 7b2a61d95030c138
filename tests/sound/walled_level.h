#pragma once

#include <array>
#include <utility>

#include "tests/game/toy_game.h"

namespace oblong::test {

/// A toy level with a wall for lines too: solid from x = 100 to 116, for all y and z.
inline ToyLevel with_wall() {
    ToyLevel toy;
    toy.add_model(floor_and({}));
    Level& level = toy.level;
    const auto plane_at = [&](std::int32_t x) {
        LevelPlane plane;
        plane.axis = 0;
        plane.normal.x = Unit::from_int(1);
        plane.distance = PlaneDistance::from_int(x);
        level.planes.push_back(plane);
        return PlaneIndex(level.planes.count() - 1);
    };
    Node far_side;
    far_side.plane = plane_at(116);
    far_side.children = {NodeChild(LeafIndex(1)), NodeChild(LeafIndex(0))};
    level.nodes.push_back(far_side);
    Node& near_side = level.nodes[NodeIndex(0)];
    near_side.plane = plane_at(100);
    near_side.children = {NodeChild(NodeIndex(1)), NodeChild(LeafIndex(1))};
    return toy;
}

/// A toy level with a column for lines: solid from x = 40 to 60 and y = -10 to 10, for all z.
inline ToyLevel with_column() {
    ToyLevel toy;
    toy.add_model(floor_and({}));
    Level& level = toy.level;
    constexpr std::array<std::pair<std::uint8_t, int>, 4> kPlanes{{{0, 60}, {0, 40}, {1, 10}, {1, -10}}};
    for (std::size_t i = 0; i < kPlanes.size(); ++i) {
        const auto [axis, distance] = kPlanes[i];
        LevelPlane plane;
        plane.axis = axis;
        (axis == 0 ? plane.normal.x : plane.normal.y) = Unit::from_int(1);
        plane.distance = PlaneDistance::from_int(distance);
        level.planes.push_back(plane);
        const NodeChild open(LeafIndex(1)), solid(LeafIndex(0));
        const bool is_high = i % 2 == 0, is_last = i + 1 == kPlanes.size();
        const auto next_index = static_cast<std::uint32_t>(level.nodes.count()) + (i == 0 ? 0u : 1u);
        const NodeChild inner = is_last ? solid : NodeChild(NodeIndex(next_index));
        Node node;
        node.plane = PlaneIndex(level.planes.count() - 1);
        node.children = {is_high ? open : inner, is_high ? inner : open};
        if (i == 0)
            level.nodes[NodeIndex(0)] = node;
        else
            level.nodes.push_back(node);
    }
    return toy;
}

}  // namespace oblong::test
