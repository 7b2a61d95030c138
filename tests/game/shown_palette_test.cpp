#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "game/view/shown_view.h"

namespace oblong {
namespace {

// A level without planes: all of it is in leaf 1.
GameData data_in(std::int32_t contents) {
    GameData data;
    data.level.leaves.resize(2);
    data.level.leaves[LeafIndex(0)].contents = contents::kSolid;
    data.level.leaves[LeafIndex(1)].contents = contents;
    SubModel world;
    world.root = NodeChild(LeafIndex(1));
    data.level.models.push_back(world);
    return data;
}

GameState state_at(std::int64_t tick, std::int32_t x) {
    GameState state;
    state.tick = tick;
    state.player.position.x = World::from_int(x);
    return state;
}

TEST(ShownPalette, FlashesAndFadesAfterATeleporterOnly) {
    const GameData data = data_in(contents::kEmpty);
    ShownPalette palette(data);
    const auto flash_at = [&](std::int64_t tick, Flashes flashes) {
        const GameState state = state_at(tick, 0);
        return palette.effects_at({{state, state}, {}}, flashes, {}, false).flash.share_256;
    };
    palette.note_tick(state_at(99, 0), state_at(100, 20));
    EXPECT_EQ(flash_at(99, Flashes::Full), 0) << "walking is none";
    palette.note_tick(state_at(100, 20), state_at(101, 2000));
    EXPECT_GT(flash_at(100, Flashes::Full), 100);
    for (std::int64_t tick = 101; tick < 114; ++tick)
        EXPECT_LT(flash_at(tick, Flashes::Full), flash_at(tick - 1, Flashes::Full)) << tick;
    EXPECT_EQ(flash_at(115, Flashes::Full), 0);
    for (const Flashes flashes : {Flashes::Reduced, Flashes::Off}) EXPECT_EQ(flash_at(100, flashes), 0);
}

TEST(ShownPalette, IsPlainInTheOpenAndTintedInALiquid) {
    const GameState state = state_at(0, 0);
    const GameView view{{state, state}, {}};
    const GameData open = data_in(contents::kEmpty), water = data_in(contents::kWater);
    EXPECT_TRUE(ShownPalette(open).effects_at(view, Flashes::Full, {}, false).is_plain());
    EXPECT_FALSE(ShownPalette(open).effects_at(view, Flashes::Full, {100, 150}, false).is_plain());
    EXPECT_EQ(ShownPalette(water).effects_at(view, Flashes::Off, {}, false).liquid, (Tint{{130, 80, 50}, 128}));
}

// The tube's colours, then gamma of the display; both of the light that was asked for last.
TEST(ShownPalette, ATubesColoursComeBeforeGamma) {
    const GameData data = data_in(contents::kEmpty);
    const GameState state = state_at(0, 0);
    const GameView view{{state, state}, {}};
    ShownPalette palette(data);
    const GammaTable tube = make_tube_table(), gamma = make_gamma_table(150);
    EXPECT_EQ(palette.effects_at(view, Flashes::Full, {100, 100, true}, false).gamma, tube);
    const auto both = palette.effects_at(view, Flashes::Full, {100, 150, true}, false).gamma;
    ASSERT_TRUE(both);
    for (std::size_t value = 0; value < 256; ++value) ASSERT_EQ((*both)[value], gamma[tube[value]]) << value;
    EXPECT_EQ(palette.effects_at(view, Flashes::Full, {200, 100}, false).gamma, std::nullopt);
}

// Asked for alone, and after gamma: never more than 3 of 255 beside it, and 64 values in all.
TEST(ShownPalette, AVgaShowsSixBitsOfWhatGammaMade) {
    const GameData data = data_in(contents::kEmpty);
    const GameState state = state_at(0, 0);
    ShownPalette palette(data);
    for (const std::int32_t gamma_100 : {100, 150}) {
        const GammaTable gamma = make_gamma_table(gamma_100);
        const auto shown = palette.effects_at({{state, state}, {}}, Flashes::Full, {100, gamma_100}, true).gamma;
        ASSERT_TRUE(shown);
        for (std::size_t value = 0; value < 256; ++value)
            EXPECT_LE(std::abs((*shown)[value] - gamma[value]), 3) << value;
        EXPECT_LE(std::set<std::uint8_t>(shown->begin(), shown->end()).size(), 64u);
        EXPECT_EQ((*shown)[255], 255);
    }
}

}  // namespace
}  // namespace oblong
