#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/items.h"
#include "tests/game/logic_level.h"

namespace oblong::test {
namespace {

// Five lenses 300 units apart to the east, named A to E.
LogicLevel with_lenses() {
    LogicLevel level;
    for (int i = 0; i < 5; ++i)
        level.add("item_lens", {{"origin", std::to_string(300 * (i + 1)) + " 0 24"},
                                {"netname", std::string(1, static_cast<char>('A' + i))}});
    return level;
}

TEST(Goal, CountsAndNamesWhatIsFound) {
    LogicLevel level = with_lenses();
    LogicGame game(level);
    EXPECT_EQ(goal_of(game.level, game.state).count, "0 of 5");
    game.stand_at(600, 0);
    const Goal goal = goal_of(game.level, game.state);
    EXPECT_EQ(goal.count, "1 of 5");
    EXPECT_EQ(goal.hint, "") << "too many are missing";
    EXPECT_EQ(goal.list, "A: missing\nB: found\nC: missing\nD: missing\nE: missing");
    EXPECT_TRUE(last_lenses(game.level, game.state).empty());
}

TEST(Goal, LeadsToTheLastOnes) {
    LogicLevel level = with_lenses();
    LogicGame game(level);
    for (const int x : {300, 900}) game.stand_at(x, 0);
    const GameState before = game.state;
    game.stand_at(1200, 0);
    EXPECT_EQ(goal_of(game.level, game.state).hint, "Missing: B (west), E (east)");
    EXPECT_EQ(found_text(game.level, before, game.state), "Lenses: 3 of 5. Missing: B (west), E (east)");
    EXPECT_EQ(found_text(game.level, game.state, game.state), "") << "nothing new";
    EXPECT_EQ(last_lenses(game.level, game.state), (std::vector<std::size_t>{1, 4}));
    for (const int x : {600, 1500}) game.stand_at(x, 0);
    EXPECT_EQ(goal_of(game.level, game.state).hint, "");
    EXPECT_EQ(goal_of(game.level, game.state).count, "5 of 5");
}

TEST(Goal, TextsInQuakesRedLettersAreReadable) {
    const std::string red = "\xcc\xe5\xee\xf3 \xb1";
    LogicLevel level;
    level.add("worldspawn", {{"message", red}});
    level.add("item_lens", {{"origin", "300 0 24"}, {"netname", red}, {"message", red}});
    LogicGame game(level);
    EXPECT_EQ(game.level.title, "Lens 1");
    EXPECT_EQ(goal_of(game.level, game.state).list, "Lens 1: missing");
    EXPECT_EQ(std::count(game.level.messages.begin(), game.level.messages.end(), "Lens 1"), 1);
}

TEST(Secrets, WithANameAreMissedUntilTheyAreFound) {
    LogicLevel level;
    level.add("trigger_secret", {100, -50, 0, 150, 50, 64}, {{"netname", "an egg"}});
    level.add("trigger_secret", {500, -50, 0, 550, 50, 64}, {{"netname", "a lie"}});
    level.add("trigger_secret", {900, -50, 0, 950, 50, 64}, {});
    LogicGame game(level);
    EXPECT_EQ(missed_secrets(game.level, game.state), "an egg, a lie");
    game.stand_at(120, 0);
    EXPECT_EQ(missed_secrets(game.level, game.state), "a lie");
    game.stand_at(520, 0);
    EXPECT_EQ(missed_secrets(game.level, game.state), "");
}

TEST(Goal, IsNothingWithoutLenses) {
    LogicLevel level;
    LogicGame game(level);
    const Goal goal = goal_of(game.level, game.state);
    EXPECT_EQ(goal.count + goal.hint + goal.list, "");
}

// Against the angle: eight sectors of 45 degrees around the points of the compass.
TEST(Goal, DirectionsAreTheNearestOfEight) {
    constexpr std::array kNames{"east", "north-east", "north", "north-west",
                                "west", "south-west", "south", "south-east"};
    const Position from = world_vector(100, -50, 24);
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * M_PI / 180;
        const Position to = world_vector(static_cast<int>(std::lround(100 + 900 * std::cos(angle))),
                                         static_cast<int>(std::lround(-50 + 900 * std::sin(angle))), 60);
        EXPECT_EQ(direction_of(from, to), kNames.at(static_cast<std::size_t>(std::lround(degrees / 45.0)) % 8))
            << degrees;
    }
    EXPECT_EQ(direction_of(from, world_vector(110, -50, 400)), "above");
    EXPECT_EQ(direction_of(from, world_vector(110, -50, -400)), "below");
}

}  // namespace
}  // namespace oblong::test
