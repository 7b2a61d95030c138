#include "engine/surface/colormap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "tests/support/folders.h"
#include "tests/support/palettes.h"
#include "tests/surface/true_oklab.h"

namespace oblong::test {
namespace {

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
    std::vector<Palette> all = {ramp_palette(), grey_palette(), random_palette(1), random_palette(2), Palette{}};
    const auto real = read_shared_file("gfx/palette.lmp");
    if (!real.empty()) all.push_back(read_palette(real));
    return all;
}

/// Twice as bright at shade 0, the colour itself at 32, black at 63.
double light_of(std::size_t shade) {
    const double number = static_cast<double>(shade);
    return shade < 32 ? 2 - number / 32 : (63 - number) / 31;
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

TEST(Colormap, TheMiddleShadeIsTheColourItself) {
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        for (std::size_t colour = 0; colour < 256; ++colour) EXPECT_EQ(map.shades[Colormap::kOwnShade][colour], colour);
    }
}

TEST(Colormap, GreysGoFromTwiceAsBrightToBlackInEvenSteps) {
    const Colormap map = make_colormap(grey_palette());
    for (std::size_t shade = 0; shade < Colormap::kShades; ++shade)
        for (int grey = 0; grey < 224; ++grey)
            ASSERT_NEAR(map.shades[shade][static_cast<std::size_t>(grey)], std::min(grey * light_of(shade), 223.0), 1)
                << grey << " shade " << shade;
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

TrueOklab seen(Rgb8 colour, double light) {
    const auto channel = [=](std::uint8_t full) { return std::min(full * light, 255.0); };
    return true_oklab(channel(colour.red), channel(colour.green), channel(colour.blue));
}

/// A difference of hue counts eight times one of lightness.
double distance(const TrueOklab& a, const TrueOklab& b) {
    const double lightness = a[0] - b[0], green_red = a[1] - b[1], blue_yellow = a[2] - b[2];
    return std::sqrt(lightness * lightness + 8 * (green_red * green_red + blue_yellow * blue_yellow));
}

// Against the slow obvious search in doubles: among the colours that luminance allows, none is nearer by more than the
// rounding of both.
TEST(Colormap, NoAllowedColourIsNearer) {
    constexpr double kRounding = 8.0 / 4096;
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        std::vector<TrueOklab> own;
        for (const Rgb8 colour : palette.colours) own.push_back(seen(colour, 1));
        for (std::size_t colour = 0; colour < 224; colour += 5)
            for (std::size_t shade = 1; shade + 1 < Colormap::kShades; shade += 3) {
                if (shade == Colormap::kOwnShade) continue;
                const bool is_darker = shade > Colormap::kOwnShade;
                const double limit = luminance(palette.colours[map.shades[is_darker ? shade - 1 : shade + 1][colour]]);
                const TrueOklab target = seen(palette.colours[colour], light_of(shade));
                const double found = distance(own[map.shades[shade][colour]], target);
                for (std::size_t other = 0; other < 224; ++other) {
                    const double brightness = luminance(palette.colours[other]);
                    if (is_darker ? brightness >= limit - 1e-9 : brightness <= limit + 1e-9) continue;
                    ASSERT_LE(found, distance(own[other], target) + kRounding)
                        << colour << ' ' << shade << ' ' << other;
                }
            }
    }
}

/// Ramps of 16 steps from black, of colours that darken into one another's neighbourhood: grey, slate, tan, brown,
/// olive, brick.
Palette wall_palette() {
    constexpr std::array<Rgb8, 6> kBrightest{Rgb8{235, 235, 235}, {150, 160, 205}, {225, 200, 160},
                                             {150, 105, 55},      {110, 110, 35},  {180, 75, 50}};
    Palette palette;
    for (std::size_t i = 0; i < 96; ++i) {
        const Rgb8 full = kBrightest[i / 16];
        const auto channel = [i](int brightest) { return static_cast<std::uint8_t>(brightest * (i % 16) / 15); };
        palette.colours[i] = {channel(full.red), channel(full.green), channel(full.blue)};
    }
    return palette;
}

TEST(Colormap, DarkShadesStayOnTheirRamp) {
    const Palette palette = wall_palette();
    const Colormap map = make_colormap(palette);
    for (std::size_t colour = 0; colour < 96; ++colour)
        for (std::size_t shade = Colormap::kOwnShade; shade < Colormap::kShades; ++shade) {
            const std::size_t shown = map.shades[shade][colour];
            const bool is_nearly_black = luminance(palette.colours[shown]) < 25;
            EXPECT_TRUE(is_nearly_black || shown / 16 == colour / 16)
                << colour << " shade " << shade << " is " << shown;
        }
}

TEST(Colormap, FewerShadesReachFromTheBrightestToTheDarkest) {
    const Colormap map = numbered_shades();
    for (const std::int32_t count : {16, 32, 64}) {
        const Colormap fewer = with_shades(map, count);
        std::set<int> shades;
        for (int shade = 0; shade < 64; ++shade) {
            const int shown = fewer.shades[static_cast<std::size_t>(shade)][7];
            shades.insert(shown);
            EXPECT_LE(std::abs(shown - shade), 64 / count) << shade << " of " << count;
        }
        EXPECT_EQ(shades.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(*shades.begin(), 0);
        EXPECT_EQ(*shades.rbegin(), 63);
        EXPECT_EQ(fewer.shades[Colormap::kOwnShade][7], Colormap::kOwnShade) << count;
    }
}

}  // namespace
}  // namespace oblong::test
