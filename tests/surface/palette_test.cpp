#include "engine/surface/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "engine/base/input_error.h"
#include "tests/support/shared_levels.h"

namespace oblong {
namespace {

TEST(Palette, TakesTriplesInOrder) {
    std::vector<std::uint8_t> bytes(768);
    bytes[0] = 1, bytes[1] = 2, bytes[2] = 3, bytes[767] = 4;
    const Palette palette = read_palette(bytes);
    EXPECT_EQ(palette.colours[0], (Rgb8{1, 2, 3}));
    EXPECT_EQ(palette.colours[255], (Rgb8{0, 0, 4}));
}

TEST(Palette, OtherSizesAreRefused) {
    for (const std::size_t size : {0u, 767u, 769u, 1024u})
        EXPECT_THROW(read_palette(std::vector<std::uint8_t>(size)), InputError) << size;
}

// Hard case P3: a shift alone would make the brightest colour 252.
TEST(Palette, SixBitsWidenToTheWholeRangeAndBack) {
    for (int v = 0; v < 64; ++v) {
        const std::uint8_t wide = widen_dac6(static_cast<std::uint8_t>(v));
        EXPECT_EQ(narrow_dac6(wide), v);
        EXPECT_LE(std::abs(wide * 63 - v * 255), 63) << "within one of " << v << " / 63";
    }
    EXPECT_EQ(widen_dac6(0), 0);
    EXPECT_EQ(widen_dac6(63), 255);
}

TEST(Palette, ShownTwiceIsShownOnce) {
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) {
        const auto c = static_cast<std::uint8_t>(i);
        palette.colours[i] = {c, static_cast<std::uint8_t>(255 - c), static_cast<std::uint8_t>(c * 7)};
    }
    const Palette once = as_shown_by_dac6(palette);
    EXPECT_EQ(once.colours[129].red, 32 * 4 + 2);
    EXPECT_EQ(as_shown_by_dac6(once).colours, once.colours);
}

double luminance(Rgb8 colour) {
    return 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue;
}

Palette random_palette(unsigned seed) {
    std::mt19937 random(seed);
    Palette palette;
    for (Rgb8& colour : palette.colours) {
        const auto bits = static_cast<std::uint32_t>(random());
        colour = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                  static_cast<std::uint8_t>(bits >> 16)};
    }
    return palette;
}

/// 16 hues of 16 shades, as a DOS artist would have laid them out; [0] is black.
Palette ramp_palette() {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        const int hue = i / 16, light = i % 16 * 17;
        const auto part = [light](int weight) { return static_cast<std::uint8_t>(light * weight / 3); };
        palette.colours[static_cast<std::size_t>(i)] = {part(hue & 3), part(hue >> 2), part((hue ^ hue >> 2) & 3)};
    }
    return palette;
}

std::vector<Palette> palettes() {
    std::vector<Palette> all = {ramp_palette(), random_palette(1), random_palette(2), Palette{}};
    const auto real = test::read_shared_file("gfx/palette.lmp");
    if (!real.empty()) all.push_back(read_palette(real));
    return all;
}

// Hard case P1.
TEST(Colormap, LuminanceNeverRisesWithTheShade) {
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        for (std::size_t colour = 0; colour < 256; ++colour) {
            for (std::size_t shade = 1; shade < Colormap::kShades; ++shade) {
                const Rgb8 before = palette.colours[map.shades[shade - 1][colour]];
                const Rgb8 after = palette.colours[map.shades[shade][colour]];
                ASSERT_LE(luminance(after), luminance(before) + 1e-9) << "colour " << colour << " shade " << shade;
            }
        }
    }
}

TEST(Colormap, FirstShadeIsTheColourItself) {
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        for (std::size_t colour = 0; colour < 256; ++colour) EXPECT_EQ(map.shades[0][colour], colour);
    }
}

TEST(Colormap, LastShadeIsBlackWhereThePaletteHasIt) {
    const Palette palette = ramp_palette();
    const Colormap map = make_colormap(palette);
    for (std::size_t colour = 0; colour < 224; ++colour)
        EXPECT_EQ(palette.colours[map.shades[Colormap::kShades - 1][colour]], (Rgb8{0, 0, 0}));
}

// Hard case P2.
TEST(Colormap, FullbrightsStayAndNoOtherColourBecomesOne) {
    for (const Palette& palette : palettes()) {
        for (const int fullbrights : {0, 32, 256}) {
            const Colormap map = make_colormap(palette, fullbrights);
            const auto first = static_cast<std::size_t>(256 - fullbrights);
            for (const auto& shade : map.shades) {
                for (std::size_t colour = 0; colour < first; ++colour) ASSERT_LT(shade[colour], first);
                for (std::size_t colour = first; colour < 256; ++colour) ASSERT_EQ(shade[colour], colour);
            }
        }
    }
}

double difference(Rgb8 a, Rgb8 b, double scale) {
    const double red = a.red - b.red * scale, green = a.green - b.green * scale, blue = a.blue - b.blue * scale;
    return 0.299 * red * red + 0.587 * green * green + 0.114 * blue * blue;
}

// Against the slow obvious search: among colours no lighter than the shade before, none is nearer. The target rounds
// to whole channels, which may move a distance by half a step a channel.
TEST(Colormap, NoAllowedColourIsNearer) {
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        for (std::size_t colour = 0; colour < 224; ++colour) {
            for (std::size_t shade = 1; shade < Colormap::kShades; shade += 3) {
                const double scale = (63.0 - static_cast<double>(shade)) / 63;
                const double limit = luminance(palette.colours[map.shades[shade - 1][colour]]) - 1e-9;
                const double found =
                    difference(palette.colours[map.shades[shade][colour]], palette.colours[colour], scale);
                for (std::size_t other = 0; other < 224; ++other) {
                    if (luminance(palette.colours[other]) >= limit) continue;
                    const double nearest = difference(palette.colours[other], palette.colours[colour], scale);
                    ASSERT_LE(std::sqrt(found), std::sqrt(nearest) + 1) << colour << ' ' << shade << ' ' << other;
                }
            }
        }
    }
}

}  // namespace
}  // namespace oblong
