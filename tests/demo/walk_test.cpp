#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "game/level/load.h"
#include "game/simulation/collision.h"
#include "game/simulation/rooms.h"
#include "game/view/game_renderer.h"
#include "tests/demo/visitor.h"
#include "tests/support/levels.h"
#include "tests/support/programs.h"
#include "tests/support/refusal.h"
#include "tests/support/views.h"

namespace oblong::test::walk_test {
namespace {

class DemoWalk : public testing::Test {
  protected:
    void walk(const std::vector<test::Waypoint>& route) { visitor_.walk(route); }

    const Level level_ = read_level("demo");
    test::Visitor visitor_{level_};
};

const std::vector<test::Waypoint> kEntranceToGallery{{0, -16}, {0, 200}, {200, 416}, {400, 416}};
const std::vector<test::Waypoint> kCourtyardToTower{
    {512, 1420},  {-60, 1600},  {-200, 1600}, {-290, 1590}, {-500, 1584}, {-720, 1584}, {-792, 1620}, {-792, 2128},
    {-792, 2320}, {-540, 2290}, {-400, 2290}, {-80, 2320},  {512, 2320},  {512, 2200},  {512, 1900}};

TEST_F(DemoWalk, TheTowerIsShutAtBothGatesWhileLensesAreMissing) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}, {512, 1540}});
    EXPECT_FALSE(visitor_.walk_to({512, 1640})) << "from the courtyard";
    walk({{512, 1420}});
    walk(kCourtyardToTower);
    EXPECT_FALSE(visitor_.walk_to({512, 1800})) << "from the corridor";
}

// Each lens has a room whose name its own begins with. Who begins there stands on its floor, and looks at the lens.
TEST_F(DemoWalk, BeginsInAnyRoom) {
    const GameLevel level = make_game_level(level_);
    const std::vector<Room> rooms = rooms_of(level);
    int of_lenses = 0;
    for (const Room& room : rooms) {
        GameState state = start_of(level);
        std::string name = room.name;
        std::replace(name.begin(), name.end(), ' ', '-');
        enter_room(name, level, state);
        ASSERT_TRUE(is_free(level, state, state.player.position)) << name;
        const Player entered = state.player;
        for (int tick = 0; tick < kTicksPerSecond; ++tick) step(level, state, {});
        EXPECT_NE(state.player.ground, Player::kNoGround) << name;
        EXPECT_LT(std::abs(number_of(state.player.position.z) - number_of(entered.position.z)), 45) << name;
        for (const Item& item : level.items) {
            const std::string lens = lower_case(level_.entities[item.entity].value("netname"));
            if (!lens.starts_with(room.name) && !lens.starts_with("the " + room.name)) continue;
            ++of_lenses;
            const double to_lens = std::atan2(number_of(item.position.y) - number_of(entered.position.y),
                                              number_of(item.position.x) - number_of(entered.position.x));
            EXPECT_NEAR(std::remainder(to_lens - radians_of(entered.yaw), 2 * std::numbers::pi), 0, 0.001) << name;
        }
    }
    EXPECT_EQ(of_lenses, 12);
    GameState state = start_of(level);
    EXPECT_TRUE(refusal([&] {
                    enter_room("kitchen", level, state);
                }).find(": 'kitchen' is no room of this level, expected aspect, ") != std::string::npos);
}

// By walking or jumping from the tower's top, any way, one falls into the lift's shaft alone.
TEST_F(DemoWalk, NobodyFallsFromTheTowersTop) {
    const GameLevel level = make_game_level(level_);
    int falls = 0;
    for (const auto& [x, y] : {std::pair{600, 1790}, {512, 1835}})
        for (int way = 0; way < 64; ++way) {
            GameState state = start_of(level);
            state.player.position = world_vector(x, y, 464 + 24);
            TickInput input;
            input.forward = 100;
            input.yaw = static_cast<std::int16_t>(way / 2 * 2048);
            const auto is_on_top = [&] { return number_of(state.player.position.z) > 460; };
            for (int tick = 0; tick < 4 * kTicksPerSecond && is_on_top(); ++tick) {
                input.buttons = (way & tick & 1) != 0 ? kJumpButton : 0;
                step(level, state, input);
                input.yaw = 0;
            }
            const double east = number_of(state.player.position.x), north = number_of(state.player.position.y);
            EXPECT_TRUE(is_on_top() || (std::abs(east - 512) < 40 && north > 1736)) << east << ' ' << north;
            falls += is_on_top() ? 0 : 1;
        }
    EXPECT_GT(falls, 0) << "the lift is not below";
}

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

/// In the dust room the lens is the only model.
TEST(TakenItems, AreNoPartOfThePictureOrOfItsCost) {
    const GameData data = load_game({"", "", test::build_folder() + "/assets", ""});
    const GameLevel level = make_game_level(data.level);
    GameRenderer renderer(data, level, ScreenMode{});
    GameState state = start_of(level);
    const auto draws_models = [&] {
        const InterpolatedState both{state, state};
        Camera camera;
        camera.eye = world_vector(470, 144, 60);
        camera.yaw = kHalfTurn;
        camera.field_of_view = Degrees::from_int(90);
        renderer.draw({both, camera}, Settings{});
        return renderer.plan().effects.has(Effect::Meshes);
    };
    EXPECT_TRUE(draws_models());
    std::ranges::fill(state.items, ItemState::Taken);
    EXPECT_FALSE(draws_models());
}

}  // namespace
}  // namespace oblong::test::walk_test
