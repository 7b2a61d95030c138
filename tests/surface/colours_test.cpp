#include <gtest/gtest.h>

#include <set>

#include "engine/base/input_error.h"
#include "tests/support/folders.h"
#include "tests/surface/true_surface.h"

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
    std::mt19937 random(1);
    std::vector<Palette> all = {ramp_palette(), grey_palette(), Palette{}};
    for (int i = 0; i < 2; ++i) all.push_back(random_palette(random));
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

// Against the slow obvious search in doubles: among the colours that luminance allows, none is nearer by more than the
// rounding of both.
TEST(Colormap, NoAllowedColourIsNearer) {
    constexpr double kRounding = 8.0 / 4096;
    for (const Palette& palette : palettes()) {
        const Colormap map = make_colormap(palette);
        std::vector<TrueOklab> own;
        for (const Rgb8 colour : palette.colours) own.push_back(seen(colour));
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
    const std::array parts{found.lightness_14, found.green_red_14, found.blue_yellow_14};
    for (std::size_t i = 0; i < 3; ++i)
        ASSERT_NEAR(parts[i] / kOne_14, truth[i], kBound)
            << colour.red_8 << " " << colour.green_8 << " " << colour.blue_8;
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
