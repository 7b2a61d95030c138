#pragma once

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

}  // namespace oblong::test
