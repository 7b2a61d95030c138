// Tables of mixed colours against a search through all colours, on palettes of random colours.
#include "engine/effects/colour_tables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random.h"

namespace oblong::test {

namespace {

Palette random_palette(std::mt19937& random) {
    Palette palette;
    for (Rgb8& colour : palette.colours) colour = {random_byte(random), random_byte(random), random_byte(random)};
    return palette;
}

struct MixedChannels {
    std::int64_t red, green, blue;  ///< times 256 * 63, before rounding
};

MixedChannels mixed(Rgb8 front, Rgb8 behind, std::int64_t part, std::int64_t whole) {
    const auto channel = [&](std::int64_t a, std::int64_t b) {
        return ((a * part + b * (whole - part)) * 2 + whole) / (2 * whole);
    };
    return {channel(front.red, behind.red), channel(front.green, behind.green), channel(front.blue, behind.blue)};
}

std::int64_t difference(const MixedChannels& a, Rgb8 b) {
    const std::int64_t red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return 299 * red * red + 587 * green * green + 114 * blue * blue;
}

/// Whether none of the first `count` colours is nearer.
testing::AssertionResult is_nearest(const Palette& palette, const MixedChannels& wanted, std::size_t count,
                                    std::uint8_t chosen) {
    if (chosen >= count) return testing::AssertionFailure() << "fullbright " << int{chosen};
    for (std::size_t i = 0; i < count; ++i)
        if (difference(wanted, palette.colours[i]) < difference(wanted, palette.colours[chosen]))
            return testing::AssertionFailure() << i << " is nearer than " << int{chosen};
    return testing::AssertionSuccess();
}

}  // namespace

/// A share of nothing shows what is behind, one of all what is before: colours of distance 0.
TEST(BlendTable, IsTheNearestColourOfTheMixtureFullbrightOnlyIfAPartIs) {
    std::mt19937 random(1);
    const Palette palette = random_palette(random);
    for (const int share_256 : {0, 90, 128, 256}) {
        const BlendTable table = make_blend_table(palette, share_256);
        for (std::size_t front = 0; front < 256; ++front)
            for (std::size_t behind = front % 7; behind < 256; behind += 7) {
                const MixedChannels wanted = mixed(palette.colours[front], palette.colours[behind], share_256, 256);
                const std::size_t count = std::max(front, behind) < 224 ? 224 : 256;
                ASSERT_TRUE(is_nearest(palette, wanted, count, table.rows[front][behind]))
                    << front << " over " << behind << " by " << share_256;
            }
    }
}

/// Level 0 is the colour itself, the last one the fog's share of it.
TEST(FogTable, IsTheNearestColourAtEachLevelFullbrightOnlyIfItWas) {
    std::mt19937 random(4);
    const Palette palette = random_palette(random);
    const Rgb8 fog = palette.colours[77];
    for (const int share_256 : {256, 128}) {
        const FogTable table = make_fog_table(palette, fog, share_256);
        for (std::size_t level = 0; level < 64; ++level) {
            EXPECT_EQ(make_fog_level(palette, fog, share_256, static_cast<int>(level)), table.levels[level]);
            for (std::size_t colour = 0; colour < 256; colour += 5) {
                // The share is rounded down to a step of 2^-16: a channel may be rounded to the other side of a tie.
                const auto part = static_cast<std::int64_t>(level) * share_256 * 256 / 63;
                ASSERT_TRUE(is_nearest(palette, mixed(fog, palette.colours[colour], part, 65536),
                                       colour < 224 ? 224 : 256, table.levels[level][colour]))
                    << level << ", " << colour << " by " << share_256;
            }
        }
    }
}

}  // namespace oblong::test
