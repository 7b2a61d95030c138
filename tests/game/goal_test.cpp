#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/items.h"
#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong::test {
namespace {

// Five lenses 300 units apart to the east.
constexpr Scenario kGoals[] = {
    {"CountsAndNamesWhatIsFound", R"(
        + 5x item_lens origin="{300+300i} 0 24" netname=L{0+1i}
        : lenses_count = "0 of 5"
        stand 600 0: lenses_count = "1 of 5", lenses_hint = ""      # too many are missing
        : lenses_list = "L0: missing/L1: found/L2: missing/L3: missing/L4: missing"
    )"},
    {"LeadsToTheLastOnes", R"x(
        + 5x item_lens origin="{300+300i} 0 24" netname=L{0+1i}
        stand 300 0; stand 900 0; stand 1200 0: lenses_hint = "Missing: L1 (west), L4 (east)"
        stand 600 0; stand 1500 0: lenses_hint = "", lenses_count = "5 of 5"
    )x"},
    {"IsNothingWithoutLenses", R"(
        : lenses_count = "", lenses_hint = "", lenses_list = ""
    )"},
    {"SecretsWithANameAreMissedUntilTheyAreFound", R"(
        + trigger_secret 100 -50 0 150 50 64 netname="an egg"
        + trigger_secret 500 -50 0 550 50 64 netname="a lie"
        + trigger_secret 900 -50 0 950 50 64
        : missed = "an egg, a lie"
        stand 120 0: missed = "a lie"
        stand 520 0: missed = ""
    )"},
};
OBLONG_SCENARIOS(Goals, kGoals);

TEST(Goal, NamesTheLastOnesWhenOneIsFound) {
    LogicLevel level;
    for (const char* const origin : {"300 0 24", "600 0 24", "900 0 24", "1200 0 24"})
        level.add("item_lens", {{"origin", origin}, {"netname", origin}});
    LogicGame game(level);
    EXPECT_TRUE(last_lenses(game.level, game.state).empty());
    game.stand_at(300, 0);
    const GameState before = game.state;
    game.stand_at(900, 0);
    EXPECT_EQ(found_text(game.level, before, game.state), "Lenses: 2 of 4. Missing: 600 0 24 (west), 1200 0 24 (east)");
    EXPECT_EQ(found_text(game.level, game.state, game.state), "") << "nothing new";
    EXPECT_EQ(last_lenses(game.level, game.state), (std::vector<std::size_t>{1, 3}));
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

// Against the angle: eight sectors of 45 degrees around the points of the compass.
TEST(Goal, DirectionsAreTheNearestOfEight) {
    constexpr std::array kNames{"east", "north-east", "north", "north-west",
                                "west", "south-west", "south", "south-east"};
    const Position from = world_vector(100, -50, 24);
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * M_PI / 180;
        const Position to = world_vector(static_cast<int>(std::lround(100 + 900 * std::cos(angle))),
                                         static_cast<int>(std::lround(-50 + 900 * std::sin(angle))), 60);
        EXPECT_EQ(direction_of(from, to), kNames.at(as_size(std::lround(degrees / 45.0)) % 8)) << degrees;
    }
    EXPECT_EQ(direction_of(from, world_vector(110, -50, 400)), "above");
    EXPECT_EQ(direction_of(from, world_vector(110, -50, -400)), "below");
}

}  // namespace
}  // namespace oblong::test
