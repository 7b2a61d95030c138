#include "game/simulation/items.h"

#include <gtest/gtest.h>

#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kStand;
using test::LogicGame;
using test::LogicLevel;

TEST(Item, ALensIsTakenByTouchOnceCountedAndActivatesItsTarget) {
    LogicLevel level;
    level.add("item_lens", {{"origin", "300 0 24"}, {"target", "light"}, {"message", "A lens"}});
    level.add("item_lens", {{"origin", "600 0 24"}, {"target", "light"}});
    level.add("item_key1", {{"origin", "900 0 24"}});
    level.add("light", {{"targetname", "light"}, {"style", "32"}});
    LogicGame game(level);
    EXPECT_EQ(count_items(game.level, game.state, ItemClass::Lens).all, 2);
    game.stand_at(300 - 33, 0);
    EXPECT_EQ(count_items(game.level, game.state, ItemClass::Lens).taken, 0);
    EXPECT_TRUE(is_there(game.state, 0));
    game.put_at(300 - 32, 0);
    game.play(70, kStand);
    EXPECT_EQ(count_items(game.level, game.state, ItemClass::Lens).taken, 1);
    EXPECT_FALSE(is_there(game.state, 0));
    EXPECT_TRUE(is_there(game.state, 1));
    EXPECT_EQ(game.message(), "A lens");
    EXPECT_EQ(game.state.message_tick, 2);
    EXPECT_NE(game.state.dark_styles, 0u);
    game.stand_at(600, 0);
    EXPECT_EQ(game.state.dark_styles, 0u);
    EXPECT_EQ(game.message(), "A lens") << "the second says nothing";
}

TEST(Item, AKeyIsKept) {
    LogicLevel level;
    level.add("item_key1", {{"origin", "300 0 24"}}).add("item_key2", {{"origin", "600 0 24"}});
    LogicGame game(level);
    game.stand_at(300, 0);
    EXPECT_EQ(game.state.keys, kSilverKey);
    EXPECT_EQ(game.message(), "You have the silver key");
    game.stand_at(600, 0);
    EXPECT_EQ(game.state.keys, kSilverKey | kGoldKey);
    EXPECT_EQ(game.message(), "You have the gold key");
}

TEST(Item, WithoutAPlaceIsNone) {
    LogicLevel level;
    level.add("item_lens", test::Pairs{})
        .add("item_lens", {{"origin", "1 2"}})
        .add("item_lens", {{"origin", "99999 0 0"}});
    LogicGame game(level);
    EXPECT_TRUE(game.level.items.empty());
}

}  // namespace
}  // namespace oblong
