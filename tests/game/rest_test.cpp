#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "game/simulation/step.h"
#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong::test {
namespace {

// A floor with rows of doors, lifts, buttons, teleporters and triggers for the player to run through.
ToyLevel field() {
    LogicLevel level({{2000, -2048, 0, 2048, 2048, 300},
                      {-2048, -2048, 0, -2000, 2048, 300},
                      {-2048, 2000, 0, 2048, 2048, 300},
                      {-2048, -2048, 0, 2048, -2000, 300}});
    for (int row = -3; row <= 3; ++row) {
        const int y = row * 280;
        const std::string name = std::to_string(y), exit = "exit" + name;
        const auto at = [&](int x, int height) { return Solid{x, y - 50, 0, x + 40, y + 50, height}; };
        level.add("func_door", at(150, 100), {{"angle", "-1"}, {"wait", y < 0 ? "-1" : "1"}});
        level.add("func_plat", at(-250, 64), {{"height", "56"}});
        level.add("func_door", at(400, 90), {{"angle", "-1"}, {"targetname", name}, {"wait", "2"}});
        level.add("func_button", at(330, 20), {{"angle", "-2"}, {"target", name}});
        level.add(y < 0 ? "trigger_once" : "trigger_multiple", at(-450, 60), {{"target", name}});
        level.add("trigger_teleport", at(600, 60), {{"target", exit}});
        level.add("trigger_teleport", at(-600, 60), {{"target", exit}, {"targetname", name}});
        level.add("light", {{"targetname", name}, {"style", std::to_string(40 + row)}});
        level.add("info_teleport_destination",
                  {{"targetname", exit}, {"origin", "-430 " + name + " 10"}, {"angle", "30"}});
    }
    return level.take();
}

// A tree that finds all of its boxes wherever it is asked.
BoxTree tree_of_all(std::size_t count) {
    const Box all{world_vector(-40'000, -40'000, -40'000), world_vector(40'000, 40'000, 40'000)};
    std::vector<BoxTree::Entry> entries;
    for (std::uint32_t i = 0; i < count; ++i) entries.push_back({all, i});
    return BoxTree(std::move(entries));
}

// The same level, in which nothing is left out.
GameLevel where_all_is_near(GameLevel level) {
    level.boxes.touch = tree_of_all(level.movers.size());
    level.boxes.triggers = tree_of_all(level.triggers.size());
    level.boxes.obstacles = tree_of_all(level.solid_walls.size() + level.movers.size());
    return level;
}

// Steps every mover and looks at every trigger, however far.
void step_everything(const GameLevel& level, GameState& state, const TickInput& input) {
    state.active_movers.clear();
    for (std::uint32_t i = 0; i < level.movers.size(); ++i) state.active_movers.push_back(i);
    step(level, state, input);
}

TEST(AtRest, TheGameIsTheSameAsIfEverythingWereStepped) {
    ToyGame game(field());
    const GameLevel all_near = where_all_is_near(game.level);
    GameState reference = game.state;
    RandomRun run;
    std::size_t most = 0, at_rest = 0;
    std::uint64_t styles_seen = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
        const TickInput input = run.next();
        step(game.level, game.state, input);
        step_everything(all_near, reference, input);
        ASSERT_EQ(game.state, reference) << "tick " << tick;
        most = std::max(most, game.state.active_movers.size());
        at_rest += game.state.active_movers.empty();
        styles_seen |= game.state.dark_styles;
    }
    EXPECT_GE(most, 3u);
    EXPECT_LT(most, game.level.movers.size() / 2);
    EXPECT_GT(at_rest, 500u);
    EXPECT_GE(std::popcount(styles_seen), 3);
    const auto has_left = [](const MoverState& mover) { return mover.phase != MoverState::Phase::AtStart; };
    EXPECT_GT(std::count_if(game.state.movers.begin(), game.state.movers.end(), has_left), 0) << "doors that stay open";
}

TEST(AtRest, NoMoverIsSteppedUntilOneIsActivatedAndNoneWhenAllRestAgain) {
    ToyGame game(field());
    game.play(70, kStand);
    EXPECT_TRUE(game.state.active_movers.empty());
    game.play(16, kAhead);  // to the door of the middle row
    EXPECT_EQ(game.state.active_movers.size(), 1u);
    game.play(16, {-127, 0, 0, 0, 0});
    game.play(35 * 8, kStand);
    EXPECT_TRUE(game.state.active_movers.empty());
}

constexpr Scenario kSwitchedLights[] = {
    // As in Quake: again after each wait, for as long as the player stays.
    {"GoOffAndOnEachTimeThatATriggerFires", R"(
        + trigger_multiple 100 -64 0 300 64 128 target=lamp wait=2
        + light targetname=lamp style=33
        + light targetname=lamp style=33
        play 5: dark = ""
        stand 90 0: dark = 33
        at 90 0; play 69: dark = 33
        play 1: dark = ""
    )"},
    {"GoOnOnceByATriggerOnce", R"(
        + trigger_once 100 -64 0 300 64 128 target=lamp
        + light targetname=lamp style=33 spawnflags=1
        : dark = 33
        stand 90 0: dark = ""
        wait 40; stand 90 0: dark = ""
    )"},
    // Styles below 32 are patterns, above 63 none.
    {"AreSwitchedByAButtonWhenItIsIn", R"(
        + func_button 100 -64 0 116 64 64 angle=0 target=lamp wait=1
        + light_torch targetname=lamp style=63
        + light targetname=lamp style=64
        + light targetname=lamp style=5
        play 14 ahead: phase0 = leaving, dark = ""
        play 20 ahead: phase0 = end, dark = 63
        play 20 ahead: dark = 63        # held, it stays in for its wait
        wait 100; at 83 0; play 12: phase0 = end, dark = ""
    )"},
};
OBLONG_SCENARIOS(SwitchedLights, kSwitchedLights);

TEST(SwitchedLight, IsPartOfTheStatesHash) {
    GameState lit, dark;
    dark.dark_styles = 1;
    EXPECT_NE(hash_of(lit), hash_of(dark));
}

}  // namespace
}  // namespace oblong::test
