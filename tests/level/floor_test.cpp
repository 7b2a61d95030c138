// The floor below a point against what fills the level at points further and further down.
#include <gtest/gtest.h>

#include <random>

#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "engine/level/trace.h"
#include "tests/support/shared_levels.h"
#include "tests/support/tiny_bsp.h"

namespace oblong::test {

namespace {

Vec3<World> at_height(std::int32_t z) {
    return {World::from_int(16), World::from_int(8), World::from_int(z)};
}

}  // namespace

TEST(Floor, IsFoundBelowAPoint) {
    const Level level = read_bsp(join_lumps(29, make_tiny_lumps()));
    const auto floor = find_floor(level, at_height(100), World::from_int(128));
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->position, at_height(8));
    EXPECT_EQ(floor->plane, PlaneIndex(0));
}

TEST(Floor, IsNotFoundTooFarBelowOrFromSolid) {
    const Level level = read_bsp(join_lumps(29, make_tiny_lumps()));
    EXPECT_TRUE(find_floor(level, at_height(136), World::from_int(129)));
    EXPECT_FALSE(find_floor(level, at_height(136), World::from_int(127)));
    EXPECT_FALSE(find_floor(level, at_height(4), World::from_int(128)));
    EXPECT_FALSE(find_floor(level, {World{}, World{}, World::lowest()}, World::from_int(128)));
}

TEST(Floor, IsWhereSolidBeginsInRealLevels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    constexpr std::int32_t kMost = 128, kStep = 4096 / 2;
    for (const char* name : kRealLevels) {
        const Level level = read_bsp(read_shared_file(std::string(name) + ".bsp"));
        std::mt19937 random(1);
        int found = 0, missed = 0;
        for (int trial = 0; trial < 20000; ++trial) {
            const LevelBox& box = level.world().box;
            const auto within = [&](std::size_t axis) {
                const auto size = static_cast<std::uint32_t>(box.maxs[axis] - box.mins[axis]) * 4096;
                return World::from_raw(box.mins[axis] * 4096 + static_cast<std::int32_t>(random() % size));
            };
            const Vec3<World> from{within(0), within(1), within(2)};
            const auto contents_below = [&](std::int32_t raw) {
                const Vec3<World> p{from.x, from.y, World::from_raw(from.z.raw - raw)};
                return hull_contents(level, level.world(), Hull::Point, p);
            };
            std::int32_t open = 0;  // how far it is open, in steps
            while (open < kMost * 4096 && contents_below(open) != contents::kSolid) open += kStep;
            const auto floor = find_floor(level, from, World::from_int(kMost));
            if (!floor) {
                missed += open > 0 && open < kMost * 4096 && contents_below(open - kStep) != contents::kSky;
                continue;
            }
            ++found;
            const std::int32_t depth = from.z.raw - floor->position.z.raw;
            ASSERT_GE(open, depth);
            ASSERT_LE(open, depth + kStep);
            ASSERT_EQ(contents_below(depth + 8), contents::kSolid);
            const PlaneDistance off = plane_distance(level.planes[floor->plane], floor->position);
            ASSERT_LE(absolute(off), PlaneDistance::from_raw(std::int64_t{1} << 32)) << "within 1/1,024 unit";
        }
        EXPECT_GT(found, 50);
        EXPECT_LT(missed, found / 4) << "steep ones";
    }
}

}  // namespace oblong::test
