// The dome of the sky against its formula in doubles: the direction through a pixel's centre with its height tripled,
// of length 378 texels (of a 128-texel sky), seen from above.
#include "engine/effects/sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace oblong::test {

namespace {

constexpr std::int32_t kSize = 128, kStep_px = 8;
/// Texels that lines of 8 pixels may be off the dome: 8^2 / 8 times its curvature, 378 * 9 / 160^2 texels a pixel
/// squared where it bends most (heights are tripled), at 160 pixels a unit; and a step of 2^-16.
constexpr double kLineError_texels = 8 * 378 * 9.0 / (160 * 160) + 0.01;

enum class Axis { U, V };

/// A sky of clouds whose texels are 1 more than their column or row.
std::vector<std::uint8_t> numbered_clouds(Axis axis) {
    std::vector<std::uint8_t> texels(2 * kSize * kSize, 255);
    for (std::int32_t v = 0; v < kSize; ++v)
        for (std::int32_t u = 0; u < kSize; ++u)
            texels[static_cast<std::size_t>(v * 2 * kSize + u)] =
                static_cast<std::uint8_t>((axis == Axis::U ? u : v) + 1);
    return texels;
}

/// 320x200 pixels of nothing but sky, at 90 degrees.
class SkyPicture {
  public:
    explicit SkyPicture(const Basis& axes) : axes_(axes) {}

    void draw(const std::vector<std::uint8_t>& texels) {
        std::vector<Span> spans;
        for (std::int32_t y = 0; y < 200; ++y) spans.push_back({y, 0, 320});
        draw_sky(spans, {texels.data(), kSize, 2 * kSize}, axes_, projection_, {pixels_.data(), 320, 200, 320});
    }
    std::uint8_t at(std::int32_t column, std::int32_t row) const {
        return pixels_[static_cast<std::size_t>(row * 320 + column)];
    }
    /// In texels from the zenith, by the formula.
    double dome(std::int32_t column, std::int32_t row, Axis axis) const {
        const double right = (column + 0.5 - 160) / 160, up = -(row + 0.5 - 100) / 100 * 0.75;
        const auto along = [&](Unit r, Unit u, Unit f) { return std::ldexp(r.raw * right + u.raw * up + f.raw, -30); };
        const double x = along(axes_.right.x, axes_.up.x, axes_.forward.x);
        const double y = along(axes_.right.y, axes_.up.y, axes_.forward.y);
        const double z = along(axes_.right.z, axes_.up.z, axes_.forward.z);
        return 378 * (axis == Axis::U ? x : y) / std::hypot(x, y, 3 * z);
    }

  private:
    Basis axes_;
    Projection projection_ = make_projection(ScreenMode{}, Degrees::from_int(90));
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(320 * 200);
};

/// How far `place` is outside of texel [index, index + 1), round the sky; 0 inside.
double distance_to_texel(double place, std::int32_t index) {
    const double past = place - index - kSize * std::floor((place - index) / kSize);
    return past < 1 ? 0 : std::min(past - 1, kSize - past);
}

std::int32_t steps_between(std::uint8_t a, std::uint8_t b) {
    const std::int32_t apart = std::abs(a - b);
    return std::min(apart, kSize - apart);
}

Basis random_axes(std::mt19937& random) {
    return view_basis(Angle::from_bam(random()), Angle::from_bam(random()), Angle::from_bam(random()));
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
                    ASSERT_LE(off, column % kStep_px == 0 ? 0.01 : kLineError_texels) << column << ", " << row;
                }
        }
}

TEST(Sky, DoesNotJumpFromStepToStep) {
    // A pixel is 1/160 of the view's unit, and the dome's slope at most 378 * 3 texels a unit where heights are
    // tripled.
    constexpr std::int32_t kMost_texels = 378 * 3 / 160 + 1;
    std::mt19937 random(2);
    for (int trial = 0; trial < 40; ++trial)
        for (const Axis axis : {Axis::U, Axis::V}) {
            SkyPicture picture(random_axes(random));
            picture.draw(numbered_clouds(axis));
            for (std::int32_t row = 0; row < 200; row += 3)
                for (std::int32_t column = 1; column < 320; ++column)
                    ASSERT_LE(steps_between(picture.at(column - 1, row), picture.at(column, row)), kMost_texels + 1)
                        << column << ", " << row;
        }
}

TEST(Sky, AQuarterTurnOfTheEyeTurnsIt) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 40; ++trial) {
        const auto yaw = static_cast<std::uint16_t>(random());
        const Angle pitch = Angle::from_bam(random()), roll = Angle::from_bam(random());
        SkyPicture before(view_basis(Angle::from_bam(yaw), pitch, roll));
        SkyPicture after(view_basis(Angle::from_bam(yaw + 16384u), pitch, roll));
        before.draw(numbered_clouds(Axis::U));
        after.draw(numbered_clouds(Axis::V));
        int different = 0;
        for (std::int32_t row = 0; row < 200; ++row)
            for (std::int32_t column = 0; column < 320; ++column) {
                ASSERT_LE(steps_between(before.at(column, row), after.at(column, row)), 1) << column << ", " << row;
                different += before.at(column, row) != after.at(column, row);
            }
        EXPECT_LT(different, 320 * 200 / 100) << "more than what rounding does at the texels' edges";
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

TEST(Sky, PixelsOutsideOfItsSpansStay) {
    std::vector<std::uint8_t> pixels(320 * 200, 77);
    const std::vector<std::uint8_t> texels(2 * kSize * kSize, 5);
    const std::vector<Span> spans{{3, 11, 12}, {3, 20, 37}, {199, 319, 320}};
    draw_sky(spans, {texels.data(), kSize, 2 * kSize}, view_basis({}, Angle::from_bam(60000), {}),
             make_projection(ScreenMode{}, Degrees::from_int(90)), {pixels.data(), 320, 200, 320});
    EXPECT_EQ(std::count_if(pixels.begin(), pixels.end(), [](std::uint8_t p) { return p == 5; }), 1 + 17 + 1);
    EXPECT_EQ(std::count(pixels.begin(), pixels.end(), 77), 320 * 200 - (1 + 17 + 1));
    for (const std::size_t drawn : {3 * 320 + 11, 3 * 320 + 20, 3 * 320 + 36, 199 * 320 + 319})
        EXPECT_EQ(pixels[drawn], 5) << drawn;
}

}  // namespace oblong::test
