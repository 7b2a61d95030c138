#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/vec.h"
#include "engine/raster/texture_blocks.h"
#include "engine/view/texture_gradients.h"
#include "tests/hard_cases/hard_case.h"

// The gradients that a frame's faces take from their texture. Those of triangles, as outside checks ask for them, are
// in texture_test.cpp.
namespace oblong::test {
namespace {

/// A face as a frame has it: a plane before the eye, whose texture shows `texel` at a pixel.
struct SeenPlane {
    Vec3<Unit> normal;
    PlaneDistance eye_distance;
    TextureAxes texture;
    Basis axes;
    double multiplier_x = 0, multiplier_y = 0, texel = 0, z = 0;  ///< at the pixel; z below 0: not seen there

    SeenPlane(std::mt19937& random, std::int32_t size_px, const PixelPosition& pixel) {
        const auto any = [&](std::int32_t size) { return random_integer(random, -size, size); };
        const Angle yaw = Angle::from_bam(any(65536)), pitch = Angle::from_bam(any(16384));
        axes = view_basis(yaw, pitch, Angle::from_bam(any(99)));
        multiplier_x = multiplier_y = size_px / 2.0;  // 90 degrees, square pixels
        normal = normalised(Vec3<World>{{any(1 << 20)}, {any(1 << 20)}, {any(1 << 20) | 1}});
        eye_distance = PlaneDistance::from_raw(std::llround(std::exp2(random_between(random, 0, 13)) * 0x1p42));
        const auto axis = [&] { return Vec3<TexelAxis>{{any(1 << 23)}, {any(1 << 23)}, {any(1 << 23)}}; };
        texture.s = axis();
        texture.t = axis();

        const double x = (pixel.column + 0.5) / multiplier_x - 1, y = 1 - (pixel.row + 0.5) / multiplier_y;
        z = -std::ldexp(static_cast<double>(eye_distance.raw), -42) / along(normal, x, y);
        texel = random_between(random, 0, 60000);
        texture.eye_u = Texel::from_raw(std::llround((texel - z * along(texture.s, x, y)) * 65536));
        texel = std::ldexp(static_cast<double>(texture.eye_u.raw), -16) + z * along(texture.s, x, y);
    }

    /// The dot product of a vector of the world with the ray (x, y, 1) of the view.
    template <int Frac>
    double along(const Vec3<Fixed<std::int32_t, Frac>>& world, double x, double y) const {
        const auto component = [&](const Vec3<Unit>& axis) {
            return std::ldexp(static_cast<double>(dot(world, axis).raw), -Frac - 30);
        };
        return component(axes.right) * x + component(axes.up) * y + component(axes.forward);
    }
};

/// Of engine/fixed/README.md, in texels. `off_eye` is |u - eye_u|, `pixels` the way from the centre of the view.
double texel_budget(double z, double off_eye, double pixels, double texel) {
    return z * off_eye * pixels * 0x1p-45 + z * pixels * 0x1p-30 + texel * 0x1p-26 + 0x1p-13;
}

TEST(HardCaseX7, AFramesGradientsKeepTheirBudgetInEveryMode) {
    std::mt19937 random(77);
    const TexelLimits limits = make_texel_limits(65535, 65535, 0);
    for (const auto& [size_px, largest_budget] :
         {std::pair{16, 1.0 / 16}, {320, 1.0 / 16}, {1280, 0.16}, {2048, 0.26}, {kLargestMode_px, 0.51}}) {
        // The deepest pixel in a corner of the view, a texel a unit along each axis: |u - eye_u| is 3 z at most.
        EXPECT_LE(texel_budget(32768, 3 * 32768.0, size_px + 3, 65535), largest_budget);
        const InverseProjection projection =
            make_inverse_projection(make_projection({size_px, size_px, {1, 1}}, Degrees::from_int(90)));
        double worst = 0;
        int seen = 0;
        for (int i = 0; i < 20000; ++i) {
            const PixelPosition pixel{random_integer(random, 0, size_px - 1), random_integer(random, 0, size_px - 1)};
            const SeenPlane face(random, size_px, pixel);
            if (!(face.z >= 4 && face.z <= 32768)) continue;
            ++seen;
            const TextureGradients gradients = make_texture_gradients(
                face.texture, make_inverse_z(face.normal, face.eye_distance, face.axes, projection), face.axes,
                projection);
            const double found = texel_at(gradients, limits, pixel.column, pixel.row).u_16 / 65536.0;
            const double pixels = std::abs(pixel.column - size_px / 2) + std::abs(pixel.row - size_px / 2) + 3;
            const double off_eye = std::abs(face.texel - std::ldexp(static_cast<double>(face.texture.eye_u.raw), -16));
            ASSERT_NEAR(found, face.texel, texel_budget(face.z, off_eye, pixels, face.texel)) << i;
            worst = std::max(worst, std::abs(found - face.texel));
        }
        EXPECT_GT(seen, 2000);
        std::printf("largest error in %d columns: %.6f texels\n", size_px, worst);
    }
}

TEST(HardCaseE11, FacesOfOnePlaneHaveTheSameDepthsBitForBit) {
    std::mt19937 random(11);
    const auto any = [&](std::int32_t size) { return random_integer(random, -size, size); };
    for (int i = 0; i < 1000; ++i) {
        const Angle yaw = Angle::from_bam(any(65536)), pitch = Angle::from_bam(any(16384));
        const Basis axes = view_basis(yaw, pitch, Angle::from_bam(any(99)));
        const InverseProjection projection =
            make_inverse_projection(make_projection({}, Degrees::from_int(random_integer(random, 20, 150))));
        const Vec3<Unit> normal = normalised(Vec3<World>{{any(1 << 20)}, {any(1 << 20)}, {any(1 << 20) | 1}});
        const PlaneDistance eye_distance =
            PlaneDistance::from_raw(std::int64_t{random_integer(random, 1, 1 << 30)} << 22);
        const auto first = make_inverse_z(normal, eye_distance, axes, projection);
        // Whatever the faces show: their textures lie along other axes, elsewhere, and at another mip level.
        const auto axis = [&] { return Vec3<TexelAxis>{{any(1 << 23)}, {any(1 << 23)}, {any(1 << 23)}}; };
        const TextureAxes texture{axis(), axis(), Texel::from_raw(any(1 << 30)), Texel::from_raw(any(1 << 30)),
                                  random_integer(random, 0, 3)};
        const auto second = make_texture_gradients(texture, first, axes, projection).inverse_z;
        ASSERT_EQ(first.origin, second.origin) << i;
        ASSERT_EQ(first.per_column, second.per_column) << i;
        ASSERT_EQ(first.per_row, second.per_row) << i;
    }
}

}  // namespace
}  // namespace oblong::test
