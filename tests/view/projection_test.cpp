#include "engine/view/projection.h"

#include <gtest/gtest.h>

#include "engine/math/matrix.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/view/frustum.h"
#include "engine/view/texture_gradients.h"
#include "tests/support/random.h"

namespace oblong::test {

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

// With as many bits as a component has: the larger one is from 1/2 to 1.
TEST(ClipPlanes, HaveTheSlopesOfTheLens) {
    for (const int degrees : {5, 60, 90, 120, 170})
        for (const std::int32_t width_px : {320, 4096}) {
            const Projection projection = projection_of(width_px, width_px * 5 / 8, degrees);
            const Frustum frustum = make_frustum({}, projection);
            const auto check = [&](ClipNormal across, ClipNormal along, double slope) {
                const double greatest = std::max(number_of(across), number_of(along));
                EXPECT_GE(greatest, 0.5 - 0x1p-26) << degrees;
                EXPECT_LE(greatest, 1) << degrees;
                EXPECT_NEAR(number_of(across), number_of(along) * slope, 0x1p-25 * (1 + slope)) << degrees;
            };
            const auto& planes = frustum.clip_planes;
            check(planes[0].normal.x, planes[0].normal.z, 2 * number_of(projection.x.multiplier) / width_px);
            check(planes[2].normal.y, planes[2].normal.z, 2 * number_of(projection.y.multiplier) / (width_px * 5 / 8));
        }
}

/// The eye is brought into the object's space instead of the object into the eye's.
TEST(FacesAway, InObjectSpaceIsTheSameAsInTheWorld) {
    std::mt19937 random(2);
    const auto any = [&] { return random_between(random, -1, 1); };
    int differ = 0;
    for (int i = 0; i < 2'000; ++i) {
        const EulerAngles angles{random_angle(random), random_angle(random), random_angle(random)};
        const Matrix4 model = model_matrix(point_at(100 * any(), 100 * any(), 0), angles,
                                           {Entry::from_int(2), Entry::from_int(2), Entry::from_int(2)});
        const Vec3<World> corner = point_at(5 * any(), 5 * any(), 5 * any());
        const Vec3<Unit> normal = normalised(point_at(any(), any(), any()));
        const Vec3<World> eye = point_at(200 * any(), 200 * any(), 50);
        const bool in_object = faces_away(corner, normal, transformed_point(*inverse(model), eye));
        const bool in_world = faces_away(transformed_point(model, corner),
                                         normalised(*normal_matrix(linear_part(model)) * convert<Entry>(normal)), eye);
        differ += in_object != in_world;
    }
    EXPECT_LE(differ, 1) << "only a face seen edge-on, within rounding";
}

TEST(FacesAway, EdgeOnIsAwayAndTheWholeWorldFits) {
    EXPECT_TRUE(faces_away(point_at(1, 0, 0), {{}, {}, Unit::from_int(1)}, {}));
    const Vec3<World> low{World::lowest(), World::lowest(), World::lowest()};
    const Vec3<World> high{World::highest(), World::highest(), World::highest()};
    const Vec3<Unit> diagonal = normalised(widening_difference(high, low));
    EXPECT_TRUE(faces_away(high, diagonal, low));
    EXPECT_FALSE(faces_away(low, diagonal, high));
}

}  // namespace

}  // namespace oblong::test
