#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"
#include "tests/surface/true_oklab.h"

namespace oblong::test {
namespace {

TEST(Palette, TakesTriplesInOrder) {
    std::vector<std::uint8_t> bytes(768);
    bytes[0] = 1, bytes[1] = 2, bytes[2] = 3, bytes[767] = 4;
    const Palette palette = read_palette(bytes);
    EXPECT_EQ(palette.colours[0], (Rgb8{1, 2, 3}));
    EXPECT_EQ(palette.colours[255], (Rgb8{0, 0, 4}));
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

TEST(Palette, OtherSizesAreRefused) {
    for (const std::size_t size : {0u, 767u, 769u, 1024u})
        EXPECT_THROW(read_palette(std::vector<std::uint8_t>(size)), InputError) << size;
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
    constexpr std::size_t kFirst = kFirstFullbright;
    for (const Palette& palette : palettes())
        for (const auto& shade : make_colormap(palette).shades) {
            for (std::size_t colour = 0; colour < kFirst; ++colour) ASSERT_LT(shade[colour], kFirst);
            for (std::size_t colour = kFirst; colour < 256; ++colour) ASSERT_EQ(shade[colour], colour);
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

void expect_near(const FineRgb& colour) {
    constexpr double kOne_14 = 1 << 14, kBound = 1.0 / 4096;
    const Oklab found = oklab_of(colour);
    const TrueOklab truth = true_oklab(colour.red_8 / 256.0, colour.green_8 / 256.0, colour.blue_8 / 256.0);
    const auto name = [&] {
        return std::to_string(colour.red_8) + " " + std::to_string(colour.green_8) + " " +
               std::to_string(colour.blue_8);
    };
    ASSERT_NEAR(found.lightness_14 / kOne_14, truth[0], kBound) << name();
    ASSERT_NEAR(found.green_red_14 / kOne_14, truth[1], kBound) << name();
    ASSERT_NEAR(found.blue_yellow_14 / kOne_14, truth[2], kBound) << name();
}

TEST(Oklab, AgreesWithItsFormulasInDoubles) {
    for (std::int32_t red = 0; red <= 255; red += 15)
        for (std::int32_t green = 0; green <= 255; green += 15)
            for (std::int32_t blue = 0; blue <= 255; blue += 15) expect_near({red * 256, green * 256, blue * 256});
}

TEST(Oklab, SeesTheFractionsOfDarkColours) {
    for (std::int32_t red_8 = 0; red_8 < 16 * 256; red_8 += 203)
        for (std::int32_t green_8 = 0; green_8 < 16 * 256; green_8 += 317)
            for (std::int32_t blue_8 = 0; blue_8 < 16 * 256; blue_8 += 251) expect_near({red_8, green_8, blue_8});
}

TEST(Oklab, BlackIsZeroAndGreysHaveNoHue) {
    EXPECT_EQ(oklab_of({}).lightness_14, 0);
    for (std::int32_t grey_8 = 0; grey_8 <= 255 * 256; grey_8 += 64) {
        EXPECT_NEAR(oklab_of({grey_8, grey_8, grey_8}).green_red_14, 0, 1) << grey_8;
        EXPECT_NEAR(oklab_of({grey_8, grey_8, grey_8}).blue_yellow_14, 0, 1) << grey_8;
    }
}

}  // namespace
}  // namespace oblong::test
