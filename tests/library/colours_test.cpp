#include <gtest/gtest.h>

#include <cmath>

#include "engine/library/oblong.h"
#include "tests/support/palettes.h"

namespace oblong {
namespace {

TEST(LibraryColours, RampIsEvenAndACycleComesBack) {
    Palette palette = test::grey_palette();
    set_ramp(palette, 10, 20, {0, 200, 50}, {100, 0, 50});
    for (int i = 0; i <= 10; ++i) {
        const Rgb8 colour = palette.colours[static_cast<std::size_t>(10 + i)];
        EXPECT_NEAR(colour.red, 10 * i, 1) << i;
        EXPECT_NEAR(colour.green, 200 - 20 * i, 1) << i;
        EXPECT_EQ(colour.blue, 50) << i;
    }
    const Palette before = palette;
    cycle_colours(palette, 10, 20, 3);
    for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(palette.colours[10 + (i + 3) % 11], before.colours[10 + i]) << i;
    cycle_colours(palette, 10, 20, -14);
    EXPECT_EQ(palette.colours, before.colours);
    EXPECT_THROW(set_ramp(palette, 10, 256, {}, {}), std::runtime_error);
    EXPECT_THROW(cycle_colours(palette, -1, 3, 1), std::runtime_error);
}

TEST(LibraryColours, MixtureIsEvenAndKeepsWhatItIsNotTold) {
    const Palette grey = test::grey_palette();
    EXPECT_EQ(mixed(grey, {9, 9, 9}, -5).colours, grey.colours);
    EXPECT_EQ(mixed(grey, {0, 200, 100}, 300).colours[50], (Rgb8{0, 200, 100}));
    const Rgb8 half = mixed(grey, {0, 200, 100}, 128).colours[50];
    EXPECT_EQ(half, (Rgb8{25, 125, 75}));
}

// A file in memory: a TGA of three colours, the second twice and the last transparent; then a grey ramp.
TEST(LibraryColours, ArePicturesOwnWhereTheyFit) {
    std::vector<std::uint8_t> tga{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 32, 8};
    tga.insert(tga.end(), {5, 6, 7, 255, 50, 60, 70, 255, 50, 60, 70, 255, 1, 1, 1, 0});
    const File few("few.tga", tga);
    Palette palette = test::grey_palette();
    set_from_pictures(palette, 10, 20, {few});
    EXPECT_EQ(palette.colours[10], (Rgb8{7, 6, 5}));
    EXPECT_EQ(palette.colours[11], (Rgb8{70, 60, 50}));
    EXPECT_EQ(palette.colours[12], (Rgb8{12, 12, 12})) << "as before";
    const Picture shown = load_picture(few, palette);
    EXPECT_EQ(shown.pixels, (std::vector<std::uint8_t>{10, 11, 11, kTransparent}));

    std::vector<std::uint8_t> ramp{0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 8, 0};
    for (int i = 0; i < 256; ++i) ramp.push_back(static_cast<std::uint8_t>(i));
    set_from_pictures(palette, 0, 31, {File("ramp.tga", ramp)});
    for (std::size_t i = 0; i < 32; ++i) EXPECT_NEAR(palette.colours[i].green, double(8 * i) + 3.5, 4) << i;
    EXPECT_THROW(set_from_pictures(palette, 0, 256, {few}), std::runtime_error);
    EXPECT_THROW(set_from_pictures(palette, 0, 9, {"none.png"}), std::runtime_error);
}

TEST(LibraryNumbers, SinesAreThoseOfDoubles) {
    constexpr double kPi = 3.14159265358979;
    for (std::int64_t degrees_256 = -200'000; degrees_256 < 200'000; degrees_256 += 37)
        // An angle is rounded to 1/65,536 turn.
        EXPECT_NEAR(sine_65536(degrees_256), 65'536 * std::sin(double(degrees_256) / 256 * kPi / 180), 4)
            << degrees_256;
}

TEST(LibraryNumbers, MovesAheadAndRight) {
    const Pose north = pose_at(10, 20, 30, 90);
    EXPECT_EQ(moved(north, 512, 0), pose_at(10, 22, 30, 90));
    EXPECT_EQ(moved(north, 0, 512), pose_at(12, 20, 30, 90));
    EXPECT_EQ(moved(pose_at(0, 0, 0, 180), 256, 256, 256), pose_at(-1, 1, 1, 180));
}

TEST(LibraryNumbers, DirectionsAndRootsAreThoseOfDoubles) {
    for (std::int64_t degrees = 0; degrees < 360; ++degrees) {
        const std::int64_t x = sine_65536((degrees + 90) * 256), y = sine_65536(degrees * 256);
        EXPECT_NEAR(direction_256(x, y), double(degrees) * 256, 2) << degrees;
    }
    EXPECT_EQ(direction_256(-5, 0), 180 * 256);
    EXPECT_LT(direction_256(100'000'000, -1), 360 * 256);
    for (const std::uint64_t value : {0u, 1u, 24u, 25u, 26u, 1'000'000u})
        EXPECT_EQ(integer_root(value), std::floor(std::sqrt(double(value))));
}

// The first numbers of the generator's published test (Vigna's splitmix64.c from 0): their upper halves times the
// limit.
TEST(LibraryNumbers, RandomNumbersAreThoseOfSplitMix) {
    constexpr std::uint64_t kPublished[] = {0xE220'A839'7B1D'CDAF, 0x6E78'9E6A'A1B9'65F4, 0x06C4'5D18'8009'454F};
    std::uint64_t state = 0;
    for (const std::uint64_t published : kPublished)
        EXPECT_EQ(random_below(1000, state), static_cast<std::int32_t>((published >> 32) * 1000 >> 32));
}

}  // namespace
}  // namespace oblong
