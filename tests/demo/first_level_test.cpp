#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "tests/demo/visitor.h"
#include "tests/support/programs.h"

namespace oblong::test {
namespace {

// The level of "Build your own level" (tools/map/README.md), compiled without a warning: the player steps before the
// door, which opens, rides the lift to the ledge, and jumps over the rim of the basin.
TEST(FirstLevel, HasADoorThatOpensALiftThatLiftsAndWater) {
    const TemporaryFolder folder;
    const std::string bsp = folder.path("first.bsp");
    const Outcome compiled = run_program({"oblong-map", "--strict", source_folder() + "/assets/first_level.map", "-o",
                                          bsp, "--wad", build_folder() + "/assets/demo.wad"});
    ASSERT_EQ(compiled.exit_code, 0) << compiled.error;
    const Level level = read_bsp(read_file(bsp));
    Visitor visitor(level);
    const Player& player = visitor.state().player;
    visitor.walk({{0, 200}, {0, 420}});
    constexpr double kStandingOnTheLedge = 96 + 24;
    visitor.walk({{40, 600}, {144, 600, kStandingOnTheLedge - 1}, {144, 720, kStandingOnTheLedge - 1}});
    EXPECT_EQ(player.depth, Depth::Dry);
    visitor.walk({{40, 720}, {40, 500}, {-136, 500}});
    bool holds = false;
    while (player.depth == Depth::Dry && visitor.step_to(-136, 648, (holds = !holds) ? kJumpButton : 0)) continue;
    EXPECT_NE(player.depth, Depth::Dry);
}

}  // namespace
}  // namespace oblong::test
