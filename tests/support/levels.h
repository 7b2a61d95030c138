#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "engine/level/bsp_read.h"
#include "engine/level/entities.h"
#include "engine/level/side.h"
#include "engine/view/projection.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"
#include "tests/support/point.h"

/// Levels of files, and places in them.
namespace oblong::test {

/// A lit floor at z = 8 that is 32 x 16 units, 4 x 2 light samples of 100 each, u = x + 4, v = -y.
inline Level tiny_level() {
    return read_bsp(join_lumps(29, make_tiny_lumps()));
}
/// "demo" or one of kRealLevels.
inline std::vector<std::uint8_t> bytes_of_level(const std::string& name) {
    return name == "demo" ? read_file_bytes(build_folder() + "/assets/demo.bsp") : read_shared_file(name + ".bsp");
}
inline Level read_level(const std::string& name) {
    return read_bsp(bytes_of_level(name));
}

/// Tests of each level; those of real ones are skipped where there are none.
class OfLevel : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!is_demo()) OBLONG_NEEDS_SHARED_LEVELS();
    }
    static bool is_demo() { return GetParam() == std::string("demo"); }
};

/// Neither in a wall nor behind the sky.
inline bool is_open(const Level& level, const Vec3<World>& p) {
    const std::int32_t contents = level.leaves[find_leaf(level, level.world(), p)].contents;
    return contents != contents::kSolid && contents != contents::kSky;
}
/// A point of a box, off the grid of whole units.
inline Vec3<World> random_point_in(const LevelBox& box, std::mt19937& random) {
    const auto within = [&](std::size_t axis) {
        const auto size = static_cast<std::uint32_t>(box.maxs[axis] - box.mins[axis]) * 4096;
        return World::from_raw(box.mins[axis] * 4096 + static_cast<std::int32_t>(random() % size | 1));
    };
    return {within(0), within(1), within(2)};
}
inline Vec3<World> random_open_point(const Level& level, std::mt19937& random) {
    while (true) {
        const Vec3<World> p = random_point_in(level.world().box, random);
        if (is_open(level, p)) return p;
    }
}
/// The places of entities.
inline std::vector<Vec3<World>> entity_origins(const Level& level) {
    std::vector<Vec3<World>> points;
    for (const Entity& entity : level.entities)
        if (const auto origin = parse_world_vector(entity.value("origin"))) points.push_back(*origin);
    return points;
}
/// At entities, each looking another way.
inline std::vector<Camera> cameras_at_entities(const Level& level, std::size_t most) {
    std::vector<Camera> cameras;
    for (const Vec3<World>& origin : entity_origins(level))
        if (cameras.size() < most)
            cameras.push_back({origin, Angle::from_bam(static_cast<std::int64_t>(cameras.size()) * 7919), {}, {}});
    return cameras;
}

}  // namespace oblong::test

/// Instantiates tests that are OfLevel, named by their levels.
#define OBLONG_FOR_LEVELS(suite, ...) \
    INSTANTIATE_TEST_SUITE_P(Levels, suite, __VA_ARGS__, [](const auto& name) { return name.param; })
#define OBLONG_FOR_REAL_LEVELS(suite) OBLONG_FOR_LEVELS(suite, testing::ValuesIn(oblong::test::kRealLevels))
#define OBLONG_FOR_ALL_LEVELS(suite) OBLONG_FOR_LEVELS(suite, testing::Values("demo", "dm4", "e1m7", "end"))
