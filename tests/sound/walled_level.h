#pragma once

#include <array>
#include <utility>

#include "tests/game/logic_level.h"

namespace oblong::test {

/// A toy level with a wall for lines too: solid from x = 100 to 116, for all y and z.
inline ToyLevel with_wall() {
    ToyLevel toy;
    toy.add_model(floor_and({}));
    Level& level = toy.level;
    Node far_side;
    far_side.plane = add_plane(level, 0, 116);
    far_side.children = {NodeChild(LeafIndex(1)), NodeChild(LeafIndex(0))};
    level.nodes.push_back(far_side);
    Node& near_side = level.nodes[NodeIndex(0)];
    near_side.plane = add_plane(level, 0, 100);
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
        const NodeChild open(LeafIndex(1)), solid(LeafIndex(0));
        const bool is_high = i % 2 == 0, is_last = i + 1 == kPlanes.size();
        const auto next_index = static_cast<std::uint32_t>(level.nodes.count()) + (i == 0 ? 0u : 1u);
        const NodeChild inner = is_last ? solid : NodeChild(NodeIndex(next_index));
        Node node;
        node.plane = add_plane(level, axis, distance);
        node.children = {is_high ? open : inner, is_high ? inner : open};
        if (i == 0)
            level.nodes[NodeIndex(0)] = node;
        else
            level.nodes.push_back(node);
    }
    return toy;
}

}  // namespace oblong::test
