// The dome of the sky against its formula in doubles: the direction through a pixel's centre with its height tripled,
// of length 378 texels (of a 128-texel sky), seen from above.
#include "engine/effects/sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

#include "tests/support/random.h"

namespace oblong::test {

namespace {

/// Lines between texels that are right begin at multiples of 8, 16, 32 or 64 columns.
constexpr std::int32_t kSize = 128, kLongestLine_px = 64;
/// Texels that lines of 8 pixels may be off the dome: 8^2 / 8 times its curvature, 378 * 9 / 160^2 texels a pixel
/// squared where it bends most (heights are tripled), at 160 pixels a unit; and a step of 2^-16. Longer lines: less.
constexpr double kLineError_texels = 8 * 378 * 9.0 / (160 * 160) + 0.01;

enum class Axis { U, V };

/// A sky of clouds whose texels are 1 more than their column or row.
std::vector<std::uint8_t> numbered_clouds(Axis axis) {
    std::vector<std::uint8_t> texels(2 * kSize * kSize, 255);
    for (std::int32_t v = 0; v < kSize; ++v)
        for (std::int32_t u = 0; u < kSize; ++u)
            texels[as_size(v * 2 * kSize + u)] = static_cast<std::uint8_t>((axis == Axis::U ? u : v) + 1);
    return texels;
}

std::int64_t pixels_of(std::span<const Span> spans) {
    std::int64_t pixels = 0;
    for (const Span& span : spans) pixels += span.end - span.first;
    return pixels;
}

/// 320x200 pixels of nothing but sky, at 90 degrees.
class SkyPicture {
  public:
    explicit SkyPicture(const Basis& axes) : axes_(axes) {}

    void draw(const std::vector<std::uint8_t>& texels, std::int64_t time_ms = 0) {
        draw(all_rows(), {texels.data(), kSize, 2 * kSize}, time_ms);
    }
    /// Returns how many lines that took.
    std::int64_t draw_row(const std::vector<std::uint8_t>& texels, std::int32_t row) {
        const Span span{row, 0, 320};
        return draw({&span, 1}, {texels.data(), kSize, 2 * kSize}, 0);
    }
    std::int64_t draw(std::span<const Span> spans, const SkyTexture& sky, std::int64_t time_ms) {
        return draw_sky(spans, compose_sky(sky, time_ms, pixels_of(spans), layers_), axes_, projection_,
                        {pixels_.data(), 320, 200, 320}, best_kernels().draw_blocks);
    }
    const std::vector<std::uint8_t>& pixels() const { return pixels_; }
    std::size_t scratch_bytes() const { return layers_.tile.size(); }
    std::uint8_t at(std::int32_t column, std::int32_t row) const { return pixels_[as_size(row * 320 + column)]; }
    /// In texels from the zenith, by the formula.
    double dome(std::int32_t column, std::int32_t row, Axis axis) const {
        const double right = (column + 0.5 - 160) / 160, up = -(row + 0.5 - 100) / 100 * 0.75;
        const Point ray = to_point(axes_.right) * right + to_point(axes_.up) * up + to_point(axes_.forward);
        return 378 * (axis == Axis::U ? ray.x : ray.y) / std::hypot(ray.x, ray.y, 3 * ray.z);
    }

  private:
    Basis axes_;
    Projection projection_ = make_projection(ScreenMode{}, Degrees::from_int(90));
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(320 * 200);
    SkyLayers layers_;
};

/// How far `place` is outside of texel [index, index + 1), round the sky; 0 inside.
double distance_to_texel(double place, std::int32_t index) {
    const double past = place - index - kSize * std::floor((place - index) / kSize);
    return past < 1 ? 0 : std::min(past - 1, kSize - past);
}

/// A 128-texel sky with each texel repeated: the same picture, by more texels than are worth composing.
std::vector<std::uint8_t> enlarged(const std::vector<std::uint8_t>& texels, std::int32_t times) {
    std::vector<std::uint8_t> larger;
    for (std::int32_t v = 0; v < kSize * times; ++v)
        for (std::int32_t u = 0; u < 2 * kSize * times; ++u)
            larger.push_back(texels[as_size(v / times * 2 * kSize + u / times)]);
    return larger;
}

/// Of random colours, a third of the clouds' texels holes.
std::vector<std::uint8_t> random_sky(std::mt19937& random) {
    std::vector<std::uint8_t> texels(2 * kSize * kSize);
    for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    return texels;
}

}  // namespace

TEST(Sky, IsTheDomeWhereAStepBeginsAndNearItBetween) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 40; ++trial)
        for (const Axis axis : {Axis::U, Axis::V}) {
            SkyPicture picture(random_axes(random));
            picture.draw(numbered_clouds(axis));
            for (std::int32_t row = 0; row < 200; row += 3)
                for (std::int32_t column = 0; column < 320; ++column) {
                    const double off = distance_to_texel(picture.dome(column, row, axis), picture.at(column, row) - 1);
                    ASSERT_LE(off, column % kLongestLine_px == 0 ? 0.01 : kLineError_texels) << column << ", " << row;
                }
        }
}

TEST(Sky, LongerLinesStayWithinATexel) {
    std::mt19937 random(2);
    std::int64_t shortest = 0, blocks = 0;
    double largest = 0;
    for (int trial = 0; trial < 60; ++trial)
        for (const Axis axis : {Axis::U, Axis::V}) {
            SkyPicture picture(random_axes(random));
            const std::vector<std::uint8_t> texels = numbered_clouds(axis);
            for (std::int32_t row = 0; row < 200; row += 3) {
                const std::int64_t of_row = picture.draw_row(texels, row);
                blocks += of_row;
                shortest += 320 / 8;
                if (of_row == 320 / 8) continue;  // lines of 8 pixels, the shortest, may be further off
                for (std::int32_t column = 0; column < 320; ++column)
                    largest = std::max(largest,
                                       distance_to_texel(picture.dome(column, row, axis), picture.at(column, row) - 1));
            }
        }
    EXPECT_LT(largest, 1.01);
    EXPECT_GT(largest, 0.5) << "lines are shorter than they need be";
    EXPECT_LT(blocks * 10, shortest * 6);
}

TEST(Sky, LayersThatAreKeptAreNoPartOfThePicture) {
    std::mt19937 random(9);
    const std::vector<std::uint8_t> texels = random_sky(random), others = random_sky(random);
    const Basis axes = random_axes(random);
    SkyPicture kept(axes);
    for (const std::vector<std::uint8_t>* sky : {&texels, &others, &texels})
        for (const std::int64_t time_ms : {0, 124, 125, 300, 0}) {
            SkyPicture alone(axes);
            kept.draw(*sky, time_ms);
            alone.draw(*sky, time_ms);
            ASSERT_EQ(kept.pixels(), alone.pixels()) << time_ms;
        }
}

TEST(Sky, TheBackgroundShowsWhereCloudsAreColour0) {
    std::vector<std::uint8_t> texels = numbered_clouds(Axis::U);
    for (std::size_t i = 0; i < texels.size(); i += 2 * kSize)
        for (std::size_t u = 0; u < kSize; u += 2) {
            texels[i + u] = 0;
            texels[i + u + kSize] = static_cast<std::uint8_t>(129 + u / 2);
        }
    std::mt19937 random(4);
    const Basis axes = random_axes(random);
    SkyPicture whole(axes), holed(axes);
    whole.draw(numbered_clouds(Axis::U));
    holed.draw(texels);
    for (std::int32_t row = 0; row < 200; ++row)
        for (std::int32_t column = 0; column < 320; ++column) {
            const int u = whole.at(column, row) - 1;
            ASSERT_EQ(holed.at(column, row), u % 2 == 0 ? 129 + u / 2 : u + 1);
        }
}

TEST(Sky, TheBackgroundMovesAtHalfTheSpeedOfTheClouds) {
    std::mt19937 random(5);
    const std::vector<std::uint8_t> clouds = numbered_clouds(Axis::U);
    std::vector<std::uint8_t> background(clouds.size());
    for (std::size_t i = 0; i < clouds.size(); ++i) background[i] = i % (2 * kSize) < kSize ? 0 : clouds[i - kSize];
    for (int trial = 0; trial < 40; ++trial) {
        SkyPicture picture(random_axes(random));
        const std::int64_t time_ms = random() % 1'000'000;
        const double moved = 8.0 * static_cast<double>(time_ms) / 1000;
        for (const double times : {1, 2}) {
            picture.draw(times == 1 ? background : clouds, time_ms);
            for (std::int32_t row = 0; row < 200; row += 7)
                for (std::int32_t column = 0; column < 320; column += kLongestLine_px) {
                    const double expected = picture.dome(column, row, Axis::U) + times * moved;
                    // The clouds' second texel is added when it is whole.
                    ASSERT_LE(distance_to_texel(expected, picture.at(column, row) - 1), times == 1 ? 0.02 : 1.02)
                        << time_ms << " ms, " << column << ", " << row;
                }
        }
    }
}

TEST(Sky, RepeatsAfterItsPeriodAndAtNoTimeBefore) {
    std::mt19937 random(6);
    const std::vector<std::uint8_t> texels = random_sky(random);
    const Basis axes = random_axes(random);
    const auto at_time = [&](std::int64_t time_ms) {
        SkyPicture picture(axes);
        picture.draw(texels, time_ms);
        return picture.pixels();
    };
    const std::int64_t late_ms = (std::int64_t{1} << 40) / kSkyPeriod_ms * kSkyPeriod_ms;
    for (const std::int64_t time_ms : {0, 1, 777, 12'345, 15'999}) {
        EXPECT_EQ(at_time(time_ms), at_time(time_ms + kSkyPeriod_ms)) << time_ms;
        EXPECT_EQ(at_time(time_ms), at_time(time_ms + late_ms)) << time_ms;
        EXPECT_NE(at_time(time_ms), at_time(time_ms + kSkyPeriod_ms / 2)) << time_ms;
        EXPECT_NE(at_time(time_ms), at_time(time_ms + 125)) << time_ms;
    }
}

TEST(Sky, LargeTexturesShowTheSamePictureWithoutScratch) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 4; ++trial) {
        const std::vector<std::uint8_t> texels = random_sky(random), large = enlarged(texels, 8);
        const Basis axes = random_axes(random);
        SkyPicture composed(axes), looked_up(axes);
        const std::int64_t time_ms = 125 * trial;  // when the clouds are at a whole texel
        composed.draw(texels, time_ms);
        looked_up.draw(all_rows(), {large.data(), 8 * kSize, 16 * kSize}, time_ms);
        EXPECT_EQ(composed.scratch_bytes(), kSize * kSize);
        EXPECT_EQ(looked_up.scratch_bytes(), 0u);
        int different = 0;
        for (std::size_t i = 0; i < 320 * 200; ++i) different += composed.pixels()[i] != looked_up.pixels()[i];
        EXPECT_LT(different, 320 * 200 / 100) << "more than what rounding does at the texels' edges";
    }
}

TEST(Sky, HoldsEveryTextureSizeModeAndFieldOfView) {
    std::mt19937 random(8);
    for (std::int32_t size = 1; size <= 2048; size *= 2) {
        const std::vector<std::uint8_t> texels(as_size(2 * size * size), 9);
        for (const auto& [width, height, degrees] :
             {std::tuple{320, 200, 90}, {4096, 40, 179}, {60, 4096, 1}, {8, 4, 179}}) {
            std::vector<std::uint8_t> pixels(as_size(width * height));
            SkyLayers layers;
            const std::vector<Span> spans{{0, 0, width}, {height / 2, 1, width - 1}, {height - 1, width - 1, width}};
            const Projection projection = make_projection({width, height}, Degrees::from_int(degrees));
            const SkyNow sky = compose_sky({texels.data(), size, 2 * size}, random(), pixels_of(spans), layers);
            draw_sky(spans, sky, random_axes(random), projection, {pixels.data(), width, height, width},
                     best_kernels().draw_blocks);
            std::vector<std::uint8_t> expected(pixels.size());
            for (const Span& span : spans)
                std::fill_n(expected.begin() + span.y * width + span.first, span.end - span.first, std::uint8_t{9});
            EXPECT_EQ(pixels, expected) << size << ", " << width;
        }
    }
}

}  // namespace oblong::test
