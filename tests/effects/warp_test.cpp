// The warp of liquids against Quake's formula in doubles; the waving picture against its own, and what it may not do:
// show what is outside of the picture.
#include "engine/effects/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblong::test::warp_test {

namespace {

struct Picture {
    std::int32_t width, height, pitch;
    std::vector<std::uint8_t> pixels;

    Picture(std::int32_t width_px, std::int32_t height_px, std::int32_t padding = 0)
        : width(width_px), height(height_px), pitch(width_px + padding), pixels(as_size(pitch * height_px)) {}

    std::uint8_t& at(std::int32_t x, std::int32_t y) { return pixels[as_size(y * pitch + x)]; }
    void draw(std::int64_t time_ms) {
        UnderwaterScratch scratch;
        draw(time_ms, scratch);
    }
    void draw(std::int64_t time_ms, UnderwaterScratch& scratch) {
        draw_underwater(time_ms, scratch, {pixels.data(), width, height, pitch});
    }
};

/// How far a place modulo 256 is from another one.
double distance_256(double a, double b) {
    const double off = std::fmod(std::abs(a - b), 256);
    return std::min(off, 256 - off);
}

/// 128 pixels of 320x200 are a wave, which moves pixels by 3 to either side; in proportion in other modes.
void expect_the_formula(std::int32_t width, std::int32_t height, std::int64_t time_ms) {
    Picture columns(width, height), rows(width, height);
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            columns.at(x, y) = static_cast<std::uint8_t>(x % 256);
            rows.at(x, y) = static_cast<std::uint8_t>(y % 256);
        }
    columns.draw(time_ms);
    rows.draw(time_ms);
    const double across = std::round(width * 3 / 320.0), down = std::round(height * 3 / 200.0);
    const auto wave = [&](double place_of_mode) {
        const double steps = place_of_mode + static_cast<double>(time_ms % 6'400) / 50;
        return 1 + std::sin(2 * std::numbers::pi * steps / 128);
    };
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const double from_x = std::floor(x * (width - 2 * across) / width) + across * wave(y * 200.0 / height),
                         from_y = std::floor(y * (height - 2 * down) / height) + down * wave(x * 320.0 / width);
            ASSERT_LT(distance_256(columns.at(x, y), from_x), 0.51) << x << ", " << y << " of " << width;
            ASSERT_LT(distance_256(rows.at(x, y), from_y), 0.51) << x << ", " << y << " of " << width;
        }
}

}  // namespace

TEST(Warp, IsQuakesWaveAtEachMipLevel) {
    for (const std::int64_t time_ms : {std::int64_t{0}, std::int64_t{1}, std::int64_t{999}, std::int64_t{3'200},
                                       std::int64_t{6'399}, (std::int64_t{1} << 40) + 50}) {
        const WarpTables tables = make_warp_tables(time_ms);
        for (std::size_t mip = 0; mip < 4; ++mip)
            for (std::size_t i = 0; i < WarpTable::kEntries; ++i) {
                const double scale = std::ldexp(1.0, static_cast<int>(mip));
                const double turns = (static_cast<double>(i) * scale + static_cast<double>(time_ms % 6'400) / 50) / 128;
                const double texels = 8 * (1 + std::sin(2 * std::numbers::pi * turns)) / scale;
                // Within a step of the angle, 8 * 2 pi / 65536 texels, and one of the table.
                ASSERT_NEAR(tables[mip].shift_16[i] / 65536.0, texels, 0.0008) << time_ms << ", " << mip << ", " << i;
            }
    }
}

TEST(Warp, NeverMovesATexelBeyondItsRange) {
    for (std::int64_t time_ms = 0; time_ms < kWarpPeriod_ms; time_ms += 7) {
        const WarpTables tables = make_warp_tables(time_ms);
        for (std::size_t mip = 0; mip < 4; ++mip)
            for (const std::uint32_t shift_16 : tables[mip].shift_16) ASSERT_LE(shift_16, 16u * 65536 >> mip);
    }
}

TEST(Underwater, ShowsThePlaceThatTheFormulaSays) {
    for (const auto& [width, height] : {std::pair{320, 200}, {640, 480}, {333, 217}})
        for (const std::int64_t time_ms :
             {std::int64_t{0}, std::int64_t{100}, std::int64_t{6'399}, (std::int64_t{1} << 40) + 50})
            expect_the_formula(width, height, time_ms);
}

TEST(Underwater, ScratchOfAnotherModeOrTimeIsNoPartOfThePicture) {
    UnderwaterScratch kept;
    for (const auto& [width, height] : {std::pair{320, 200}, {320, 240}, {333, 240}, {320, 200}})
        for (const std::int64_t time_ms : {0, 50, 1'600}) {
            Picture picture(width, height), alone(width, height);
            for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                picture.pixels[i] = alone.pixels[i] = static_cast<std::uint8_t>(i * 37 % 251);
            picture.draw(time_ms, kept);
            alone.draw(time_ms);
            ASSERT_EQ(picture.pixels, alone.pixels) << width << "x" << height << ", " << time_ms;
        }
}

TEST(Underwater, EveryModeStaysWithinItsPicture) {
    for (const auto& [width, height] :
         {std::pair{8, 8}, {8, 4096}, {4096, 8}, {4096, 200}, {4096, 16}, {321, 67}, {640, 480}, {9, 11}})
        for (const std::int64_t time_ms : {0, 1'600, 3'000, 4'800}) {
            Picture picture(width, height, 5);
            for (std::int32_t y = 0; y < height; ++y)
                for (std::int32_t x = 0; x < picture.pitch; ++x) picture.at(x, y) = x < width ? 1 : 2;
            picture.draw(time_ms);
            for (std::int32_t y = 0; y < height; ++y)
                for (std::int32_t x = 0; x < picture.pitch; ++x)
                    ASSERT_EQ(picture.at(x, y), x < width ? 1 : 2) << width << "x" << height << ": " << x << ", " << y;
        }
}

}  // namespace oblong::test::warp_test
