#include "engine/effects/palette_effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace oblong::test {
namespace {

constexpr std::int64_t kLate_ms = std::int64_t{1} << 62;

/// Colour i is (i, 255 - i, 7 i mod 256).
Palette numbered_palette() {
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) {
        const auto c = static_cast<std::uint8_t>(i);
        palette.colours[i] = {c, static_cast<std::uint8_t>(255 - c), static_cast<std::uint8_t>(c * 7)};
    }
    return palette;
}

PaletteCycle cycle(std::uint8_t first, std::uint8_t last, double rate) {
    return {first, last, PaletteCycle::Rate::from_raw(static_cast<std::int64_t>(rate * 65536))};
}

/// Without planes: all of space is in leaf 1.
Level level_of_leaf(std::int32_t contents) {
    Level level;
    level.leaves.resize(2);
    level.leaves[LeafIndex(0)].contents = contents::kSolid;
    level.leaves[LeafIndex(1)].contents = contents;
    SubModel world;
    world.root = NodeChild(LeafIndex(1));
    level.models.push_back(world);
    return level;
}

Palette cycled(const PaletteCycle& moved, std::int64_t time_ms) {
    PaletteEffects effects;
    effects.cycles = {moved};
    return apply_palette_effects(numbered_palette(), effects, time_ms);
}

Palette tinted(const Tint& tint) {
    PaletteEffects effects;
    effects.liquid = tint;
    return apply_palette_effects(numbered_palette(), effects, 0);
}

TEST(PaletteEffects, NothingIsPlainAndEachEffectIsNot) {
    EXPECT_TRUE(PaletteEffects{}.is_plain());
    EXPECT_EQ(apply_palette_effects(numbered_palette(), {}, 12345).colours, numbered_palette().colours);
    PaletteEffects cycling, tinting, flashing, brightening;
    cycling.cycles = {cycle(10, 19, 1)};
    tinting.liquid = flashing.flash = {{255, 0, 0}, 1};
    brightening.gamma = make_gamma_table(150);
    for (const PaletteEffects& effects : {cycling, tinting, flashing, brightening}) EXPECT_FALSE(effects.is_plain());
}

TEST(PaletteCycle, MovesItsColoursByItsStepsAndNoOthers) {
    struct Row {
        int first, last;
        double rate;
        std::int64_t time_ms;
        int steps;  ///< up
    };
    for (const Row& row : {Row{10, 19, 2, 1500, 3},
                           {10, 19, -2, 1500, -3},
                           {10, 19, -1, 999, 0},
                           {10, 19, -1, 1000, -1},
                           {0, 255, 2, 499, 0},
                           {0, 255, 2, 500, 1},
                           {0, 255, 0.5, 1999, 0},
                           {0, 255, 0.5, 2000, 1},
                           {10, 19, -4, (std::int64_t{1} << 32) / 2500 * 2500 + 250, -1},  // its period: 2,500 ms
                           {10, 19, 4, kLate_ms / 2500 * 2500 + 250, 1},
                           {0, 255, 1000, 987'654'321, 987'654'321 % 256}}) {
        const auto first = static_cast<std::uint8_t>(row.first), last = static_cast<std::uint8_t>(row.last);
        const Palette before = numbered_palette(), after = cycled(cycle(first, last, row.rate), row.time_ms);
        for (int i = 0; i < 256; ++i) {
            const int count = row.last - row.first + 1, back = (i - row.first - row.steps + 2 * count) % count;
            const int from = i < row.first || i > row.last ? i : row.first + back;
            ASSERT_EQ(item(after.colours, i), item(before.colours, from))
                << i << " of " << row.rate << " a second at " << row.time_ms;
        }
    }
}

TEST(PaletteCycle, GoesSlowlyOrNotAtAllWhereFlashesAreNotFull) {
    LevelEffects level_effects;
    level_effects.palette_cycles = {cycle(0, 9, 100), cycle(10, 19, -100), cycle(20, 29, 2)};
    const auto shown = [&](Flashes flashes) {
        return palette_effects_at(level_of_leaf(contents::kEmpty), level_effects, {}, {}, flashes).cycles;
    };
    EXPECT_EQ(shown(Flashes::Full), level_effects.palette_cycles);
    EXPECT_EQ(shown(Flashes::Reduced), (std::vector{cycle(0, 9, 3), cycle(10, 19, -3), cycle(20, 29, 2)}));
    EXPECT_TRUE(shown(Flashes::Off).empty());
}

TEST(Tint, IsThatOfTheLeafOfTheEye) {
    for (const std::int32_t contents : {contents::kEmpty, contents::kWater, contents::kSlime, contents::kLava})
        EXPECT_EQ(palette_effects_at(level_of_leaf(contents), {}, {}, {}, Flashes::Off).liquid,
                  liquid_tint(contents, {}, {}));
}

// Quake: colour += (share * (tint - colour)) >> 8.
TEST(Tint, MixesAsQuakeDoes) {
    const Palette before = numbered_palette();
    for (const Tint& tint :
         {liquid_tint(contents::kWater, {}, {}), liquid_tint(contents::kSlime, {}, {}),
          liquid_tint(contents::kLava, {}, {}), Tint{{200, 100, 50}, 0}, Tint{{200, 100, 50}, 256}}) {
        const Palette after = tinted(tint);
        for (std::size_t i = 0; i < 256; ++i) {
            const auto mixed = [&](int from, int to) {
                return from + static_cast<int>(std::floor(tint.share_256 * (to - from) / 256.0));
            };
            ASSERT_EQ(after.colours[i].red, mixed(before.colours[i].red, tint.colour.red)) << i;
            ASSERT_EQ(after.colours[i].green, mixed(before.colours[i].green, tint.colour.green)) << i;
            ASSERT_EQ(after.colours[i].blue, mixed(before.colours[i].blue, tint.colour.blue)) << i;
        }
    }
}

TEST(Tint, OnlyLiquidsTint) {
    EXPECT_EQ(liquid_tint(contents::kWater, {}, {}), (Tint{{130, 80, 50}, 128}));
    EXPECT_EQ(liquid_tint(contents::kLava, {}, {}), (Tint{{255, 80, 0}, 150}));
    for (const std::int32_t other : {contents::kEmpty, contents::kSolid, contents::kSky, 0, -7})
        EXPECT_EQ(liquid_tint(other, {}, {}), Tint{}) << other;
}

TEST(Tint, IsTheMeanColourOfTheLevelsLiquid) {
    Level level;
    for (const char* name : {"water", "*lava", "*water", "*water2"}) {
        MipTexture texture;
        texture.name = name;
        texture.mips[3] = {10, 20, 20, 30};
        level.textures.push_back(texture);
    }
    level.textures[TextureIndex(1)].mips[3] = {100, 101};
    const Palette palette = numbered_palette();
    EXPECT_EQ(liquid_tint(contents::kWater, level, palette), (Tint{{20, 235, 140}, 128}));
    EXPECT_EQ(liquid_tint(contents::kLava, level, palette), (Tint{{100, 154, 191}, 150}));
    EXPECT_EQ(liquid_tint(contents::kSlime, level, palette), (Tint{{0, 25, 5}, 150})) << "none in the level";
}

TEST(Tint, FadesToNothingAndStaysThere) {
    constexpr Tint kRed{{255, 0, 0}, 150};
    EXPECT_EQ(faded(kRed, 0, 1000), kRed);
    EXPECT_EQ(faded(kRed, 500, 1000).share_256, kRed.share_256 / 2);
    for (const std::int64_t late : {std::int64_t{1000}, std::int64_t{1001}, std::int64_t{1} << 32, kLate_ms})
        EXPECT_EQ(faded(kRed, late, 1000).share_256, 0) << late;
    for (std::int64_t time = 1; time <= 1000; ++time)
        ASSERT_LE(faded(kRed, time, 1000).share_256, faded(kRed, time - 1, 1000).share_256);
}

TEST(Gamma, IsThePowerInDoublesAndKeepsTheOrder) {
    for (std::int32_t gamma_100 = 50; gamma_100 <= 200; ++gamma_100) {
        const GammaTable table = make_gamma_table(gamma_100);
        EXPECT_TRUE(std::is_sorted(table.begin(), table.end())) << gamma_100;
        for (int value = 0; value < 256; ++value)
            ASSERT_NEAR(item(table, value), 255 * std::pow(value / 255.0, 100.0 / gamma_100), 0.51)
                << value << " at " << gamma_100;
    }
}

// BT.1886 with a white of 1 and a black of 0.02, less that black, as sRGB.
TEST(Tube, IsTheClosedFormInDoubles) {
    constexpr double kBlack = 0.02, kGamma = 2.4;
    const double root = std::pow(kBlack, 1 / kGamma), a = std::pow(1 - root, kGamma), b = root / (1 - root);
    const GammaTable table = make_tube_table();
    for (int value = 0; value < 256; ++value) {
        const double light = (a * std::pow(value / 255.0 + b, kGamma) - kBlack) / (1 - kBlack);
        const double shown = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
        ASSERT_NEAR(item(table, value), 255 * shown, 0.51) << value;
    }
}

// GLQuake's v^0.7 (v of 255 counts as (v + 1) / 256 there) and vkQuake's (1.4 v)^0.9.
TEST(Tube, DarkColoursAreAsPortsOfQuakeShowThem) {
    const GammaTable table = make_tube_table();
    for (int value = 4; value <= 24; ++value) {
        const double gl = 255 * std::pow((value + 1) / 256.0, 0.7), vk = 255 * std::pow(1.4 * value / 255, 0.9);
        EXPECT_GT(item(table, value), std::min(gl, vk) - 0.51) << value;
        EXPECT_LT(item(table, value), std::max(gl, vk) + 0.51) << value;
    }
}

// Cycles, then tints in turn, then gamma: all others would give another colour.
TEST(PaletteEffects, ComeInOrder) {
    PaletteEffects effects;
    effects.cycles = {cycle(0, 1, 1)};
    effects.liquid = {{100, 100, 100}, 128};
    effects.flash = {{255, 0, 0}, 64};
    effects.gamma = make_gamma_table(200);
    Palette palette;
    palette.colours[0] = {40, 40, 40};
    const int red_of_one = ((40 * 128 + 100 * 128) / 256 * 192 + 255 * 64) / 256;
    const double shown = 255 * std::sqrt(red_of_one / 255.0);
    EXPECT_NEAR(apply_palette_effects(palette, effects, 1000).colours[1].red, shown, 0.51);
}

}  // namespace
}  // namespace oblong::test
