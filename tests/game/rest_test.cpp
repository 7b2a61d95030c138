#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "game/simulation/step.h"
#include "tests/game/toy_game.h"

namespace oblong {
namespace {

using test::floor_and;
using test::kAhead;
using test::kStand;
using test::Solid;
using test::ToyGame;
using test::ToyLevel;

// A floor with rows of doors, lifts, buttons, teleporters and triggers for the player to run through.
class Field {
  public:
    Field() {
        toy.add_model(floor_and({{2000, -2048, 0, 2048, 2048, 300},
                                 {-2048, -2048, 0, -2000, 2048, 300},
                                 {-2048, 2000, 0, 2048, 2048, 300},
                                 {-2048, -2048, 0, 2048, -2000, 300}}));
        for (int row = -3; row <= 3; ++row) add_row(row * 280);
    }
    ToyLevel toy;

  private:
    void add(const Solid& box, std::vector<std::pair<std::string, std::string>> pairs) {
        toy.add_model({box});
        pairs.emplace_back("model", "*" + std::to_string(++models_));
        toy.add_entity(std::move(pairs));
    }
    void add_row(int y) {
        const std::string name = std::to_string(y), exit = "exit" + name;
        const auto at = [&](int x, int height) { return Solid{x, y - 50, 0, x + 40, y + 50, height}; };
        add(at(150, 100), {{"classname", "func_door"}, {"angle", "-1"}, {"wait", y < 0 ? "-1" : "1"}});
        add(at(-250, 64), {{"classname", "func_plat"}, {"height", "56"}});
        add(at(400, 90), {{"classname", "func_door"}, {"angle", "-1"}, {"targetname", name}, {"wait", "2"}});
        add(at(330, 20), {{"classname", "func_button"}, {"angle", "-2"}, {"target", name}});
        add(at(-450, 60), {{"classname", y < 0 ? "trigger_once" : "trigger_multiple"}, {"target", name}});
        add(at(600, 60), {{"classname", "trigger_teleport"}, {"target", exit}});
        add(at(-600, 60), {{"classname", "trigger_teleport"}, {"target", exit}, {"targetname", name}});
        toy.add_entity({{"classname", "light"}, {"targetname", name}, {"style", std::to_string(40 + y / 280)}});
        toy.add_entity({{"classname", "info_teleport_destination"},
                        {"targetname", exit},
                        {"origin", "-430 " + name + " 10"},
                        {"angle", "30"}});
    }

    int models_ = 0;
};

// A tree that finds all of its boxes wherever it is asked.
BoxTree tree_of_all(std::size_t count) {
    const Box all{world_vector(-40'000, -40'000, -40'000), world_vector(40'000, 40'000, 40'000)};
    std::vector<BoxTree::Entry> entries;
    for (std::uint32_t i = 0; i < count; ++i) entries.push_back({all, i});
    return BoxTree(std::move(entries));
}

// The same level, in which nothing is left out.
GameLevel where_all_is_near(GameLevel level) {
    level.touch_boxes = tree_of_all(level.movers.size());
    level.trigger_boxes = tree_of_all(level.triggers.size());
    level.obstacles = tree_of_all(level.solid_walls.size() + level.movers.size());
    return level;
}

// Steps every mover and looks at every trigger, however far.
void step_everything(const GameLevel& level, GameState& state, const TickInput& input) {
    state.active_movers.clear();
    for (std::uint32_t i = 0; i < level.movers.size(); ++i) state.active_movers.push_back(i);
    step(level, state, input);
}

// Runs, jumps and turns at random.
class RandomInput {
  public:
    TickInput next() {
        seed_ = seed_ * 1'664'525 + 1'013'904'223;
        input_.buttons = (seed_ >> 12) % 16 == 0 ? kJumpButton : std::uint8_t{0};
        input_.yaw = 0;
        if ((seed_ >> 16) % 20 == 0) input_.yaw = static_cast<std::int16_t>(static_cast<int>(seed_ >> 18) % 12'000);
        return input_;
    }

  private:
    std::uint32_t seed_ = 3;
    TickInput input_ = kAhead;
};

TEST(AtRest, TheGameIsTheSameAsIfEverythingWereStepped) {
    ToyGame game(Field().toy);
    const GameLevel all_near = where_all_is_near(game.level);
    GameState reference = game.state;
    RandomInput random;
    std::size_t most = 0, at_rest = 0;
    std::uint64_t styles_seen = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
        const TickInput input = random.next();
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
    ToyGame game(Field().toy);
    game.play(70, kStand);
    EXPECT_TRUE(game.state.active_movers.empty());
    game.play(16, kAhead);  // to the door of the middle row
    EXPECT_EQ(game.state.active_movers.size(), 1u);
    game.play(16, {-127, 0, 0, 0, 0});
    game.play(35 * 8, kStand);
    EXPECT_TRUE(game.state.active_movers.empty());
}

// A trigger that the player runs through, with a light.
ToyLevel with_light(const char* trigger, const char* spawnflags) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{100, -64, 0, 300, 64, 128}});
    toy.add_entity({{"classname", trigger}, {"model", "*1"}, {"target", "lamp"}});
    for (int i = 0; i < 2; ++i)
        toy.add_entity({{"classname", "light"}, {"targetname", "lamp"}, {"style", "33"}, {"spawnflags", spawnflags}});
    return toy;
}

constexpr std::uint64_t kStyle33 = std::uint64_t{1} << 33;
constexpr TickInput kBack{-127, 0, 0, 0, 0};

// As in Quake: again after each wait, for as long as the player stays.
TEST(SwitchedLight, GoesOffAndOnEachTimeThatATriggerFires) {
    ToyLevel toy = with_light("trigger_multiple", "0");
    toy.level.entities.front().pairs.emplace_back("wait", "2");
    ToyGame game(std::move(toy));
    EXPECT_EQ(game.state.dark_styles, 0u);
    while (game.state.dark_styles == 0) game.play(1, kAhead);
    EXPECT_NEAR(game.x(), 84, 10);
    game.play(10, kAhead);
    game.play(59, kStand);
    EXPECT_EQ(game.state.dark_styles, kStyle33) << "69 ticks later";
    game.play(1, kStand);
    EXPECT_EQ(game.state.dark_styles, 0u);
}

TEST(SwitchedLight, GoesOnOnceByATriggerOnce) {
    ToyGame game(with_light("trigger_once", "1"));
    EXPECT_EQ(game.state.dark_styles, kStyle33);
    for (int round = 0; round < 3; ++round) {
        game.play(40, kAhead);
        EXPECT_EQ(game.state.dark_styles, 0u) << round;
        game.play(40, kBack);
    }
}

TEST(SwitchedLight, AButtonSwitchesItWhenItIsPressed) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{100, -64, 0, 116, 64, 64}});
    toy.add_entity({{"classname", "func_button"}, {"model", "*1"}, {"angle", "0"}, {"target", "lamp"}, {"wait", "1"}});
    toy.add_entity({{"classname", "light_torch"}, {"targetname", "lamp"}, {"style", "63"}});
    toy.add_entity({{"classname", "light"}, {"targetname", "lamp"}, {"style", "64"}});
    toy.add_entity({{"classname", "light"}, {"targetname", "lamp"}, {"style", "5"}});
    ToyGame game(std::move(toy));
    const std::uint64_t hash = hash_of(game.state);
    game.play(14, kAhead);
    EXPECT_EQ(game.state.dark_styles, 0u) << "not before it is in";
    game.play(20, kAhead);
    EXPECT_EQ(game.state.dark_styles, std::uint64_t{1} << 63) << "styles below 32 are patterns, above 63 none";
    GameState lit = game.state;
    lit.dark_styles = 0;
    EXPECT_NE(hash_of(lit), hash_of(game.state));
    EXPECT_NE(hash_of(lit), hash);
    game.play(20, kAhead);
    EXPECT_EQ(game.state.dark_styles, std::uint64_t{1} << 63) << "held, it stays in for its wait";
    game.play(100, kBack);
    while (game.state.movers[0].phase != MoverState::Phase::AtEnd) game.play(1, kAhead);
    EXPECT_EQ(game.state.dark_styles, 0u);
}

}  // namespace
}  // namespace oblong
