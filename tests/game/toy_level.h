#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/level/level.h"

namespace oblong::test {

/// Corners of a solid box, in whole units.
struct Solid {
    std::int32_t min_x, min_y, min_z, max_x, max_y, max_z;
};

/// Adds a plane across an axis.
inline PlaneIndex add_plane(Level& level, std::uint8_t axis, std::int32_t distance) {
    LevelPlane plane;
    plane.axis = axis;
    (axis == 0 ? plane.normal.x : axis == 1 ? plane.normal.y : plane.normal.z) = Unit::from_int(1);
    plane.distance = PlaneDistance::from_int(distance);
    level.planes.push_back(plane);
    return PlaneIndex(level.planes.count() - 1);
}

/// A tiny level of solid boxes for the player to bump into: hull 1 is a chain of boxes grown by the player's, hull 0 is
/// empty, but for water below `water_z`.
class ToyLevel {
  public:
    explicit ToyLevel(std::int32_t water_z = -30'000) {
        level.leaves.resize(3);
        level.leaves[LeafIndex(0)].contents = contents::kSolid;
        level.leaves[LeafIndex(1)].contents = contents::kEmpty;
        level.leaves[LeafIndex(2)].contents = contents::kWater;
        Node surface;
        surface.plane = add_plane(level, 2, water_z);
        surface.children = {NodeChild(LeafIndex(1)), NodeChild(LeafIndex(2))};
        level.nodes.push_back(surface);
    }

    /// Adds a model of these boxes: the first is the world, the others are entities' "*1", "*2" and so on.
    ToyLevel& add_model(const std::vector<Solid>& solids) {
        SubModel model;
        model.clip_roots[0] = chain(solids);
        const Solid& box = solids.front();
        model.box = {{box.min_x, box.min_y, box.min_z}, {box.max_x, box.max_y, box.max_z}};
        level.models.push_back(model);
        return *this;
    }

    ToyLevel& add_entity(std::vector<std::pair<std::string, std::string>> pairs) {
        level.entities.push_back({std::move(pairs)});
        return *this;
    }

    Level level;

  private:
    // Six planes of a box: outside any of them is the next box's chain, inside all is solid.
    ClipChild chain(const std::vector<Solid>& solids) {
        ClipChild next(contents::kEmpty);
        for (const Solid& s : solids) {
            ClipChild inside(contents::kSolid);
            const auto cut = [&](std::uint8_t axis, std::int32_t distance, bool solid_is_front) {
                ClipNode node;
                node.plane = add_plane(level, axis, distance);
                node.children = {solid_is_front ? inside : next, solid_is_front ? next : inside};
                level.clip_nodes.push_back(node);
                inside = ClipChild(ClipNodeIndex(level.clip_nodes.count() - 1));
            };
            cut(0, s.min_x - 16, true), cut(0, s.max_x + 16, false);
            cut(1, s.min_y - 16, true), cut(1, s.max_y + 16, false);
            cut(2, s.min_z - 32, true), cut(2, s.max_z + 24, false);
            next = inside;
        }
        return next;
    }
};

/// A floor at z = 0, 4096 units square, and what stands on it.
inline std::vector<Solid> floor_and(std::vector<Solid> others) {
    others.insert(others.begin(), {-2048, -2048, -64, 2048, 2048, 0});
    return others;
}

}  // namespace oblong::test
