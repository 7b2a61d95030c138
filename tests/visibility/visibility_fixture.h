#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"
#include "tests/support/folders.h"
#include "tests/support/point.h"

namespace oblong::test {

/// "demo" or one of kRealLevels.
inline Level read_level(const std::string& name) {
    if (name != "demo") return read_bsp(read_shared_file(name + ".bsp"));
    return read_bsp(read_file_bytes(std::filesystem::path(test::build_folder()) / "assets" / "demo.bsp"));
}

inline std::vector<Point> points_of(const Level& level, std::span<const VertexIndex> vertices, Vec3<World> offset) {
    std::vector<Point> points;
    for (const VertexIndex vertex : vertices) points.push_back(to_point(level.vertices[vertex] + offset));
    return points;
}

/// A random point of the world's box that is neither in a wall nor behind the sky, and in no plane.
inline Vec3<World> random_open_point(const Level& level, std::mt19937& random) {
    const LevelBox& box = level.world().box;
    const auto within = [&](std::size_t axis) {
        const auto size = static_cast<std::uint32_t>(box.maxs[axis] - box.mins[axis]) * 4096;
        return World::from_raw(box.mins[axis] * 4096 + static_cast<std::int32_t>(random() % size | 1));
    };
    while (true) {
        const Vec3<World> p{within(0), within(1), within(2)};
        const Leaf& leaf = level.leaves[find_leaf(level, level.world(), p)];
        if (leaf.contents != contents::kSolid && leaf.contents != contents::kSky) return p;
    }
}

}  // namespace oblong::test
