#include "engine/view/projection.h"

#include <gtest/gtest.h>

#include "engine/view/texture_gradients.h"

namespace oblong {
namespace {

__extension__ using Wide = unsigned __int128;

Projection projection_of(std::int32_t width_px, std::int32_t height_px, int degrees) {
    return make_projection({width_px, height_px, Ratio{4, 3}}, Degrees::from_int(degrees));
}

/// How far inverse * multiplier is from 1, in steps of the inverse times the multiplier: a half at most.
void expect_reciprocal(std::int64_t inverse_62, Multiplier multiplier) {
    const Wide product = Wide{static_cast<std::uint64_t>(inverse_62)} * static_cast<std::uint64_t>(multiplier.raw);
    const Wide one = Wide{1} << 94;
    const Wide off = product > one ? product - one : one - product;
    EXPECT_LE(off * 2, static_cast<std::uint64_t>(multiplier.raw));
}

TEST(DrawableLens, HasReciprocalsThatFit) {
    int drawable = 0, refused = 0;
    for (std::int32_t width_px = 1; width_px <= 400; width_px += 3) {
        for (int degrees = 1; degrees <= 179; ++degrees) {
            const Projection projection = projection_of(width_px, width_px * 3 / 4 + 1, degrees);
            if (!is_drawable(projection)) {
                ++refused;
                continue;
            }
            ++drawable;
            const InverseProjection gradients = make_inverse_projection(projection);
            expect_reciprocal(gradients.inverse_x.raw, projection.x.multiplier);
            expect_reciprocal(gradients.inverse_y.raw, projection.y.multiplier);
        }
    }
    EXPECT_GT(drawable, 20'000);
    EXPECT_GT(refused, 100);
}

TEST(DrawableLens, BeginsAtHalfAPixel) {
    // 179 degrees: 115 / 2 / tan(89.5 degrees) = 0.50178, 114 give 0.49742.
    EXPECT_TRUE(is_drawable(projection_of(115, 87, 179)));
    EXPECT_FALSE(is_drawable(projection_of(114, 87, 179)));
    // 90 degrees, one pixel: exactly half a pixel, whose reciprocal of 2 takes one bit too many.
    EXPECT_FALSE(is_drawable(projection_of(1, 1, 90)));
    EXPECT_TRUE(is_drawable(projection_of(1, 1, 89)));
}

}  // namespace
}  // namespace oblong
