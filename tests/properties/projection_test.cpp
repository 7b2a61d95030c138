// Projection never turns the order of points round.

#include "engine/view/projection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/view/project.h"

namespace oblong::test {
namespace {

__extension__ using Int128 = __int128;

/// Of a mode and a field of view that leaves what is on the screen within 64 z of the middle, as project_axis() says.
Projection any_lens() {
    ScreenMode mode;
    mode.width_px = *rc::gen::inRange(16, 2'048);
    mode.height_px = *rc::gen::inRange(16, 2'048);
    return make_projection(mode, Degrees::from_int(*rc::gen::inRange(1, 179)));
}

/// From next to the eye to the far end of the world, evenly over its powers of two.
std::int64_t any_depth_16() {
    return *rc::gen::inRange<std::int64_t>(4, 8) << *rc::gen::inRange(0, 29);
}

/// Between -limit and limit.
std::int64_t within(std::int64_t limit) {
    return *rc::gen::inRange<std::int64_t>(-limit, limit + 1);
}

ScreenPosition shown(const Projection& projection, std::int64_t x_16, std::int64_t y_16, std::int64_t z_16) {
    return project({View::from_raw(x_16), View::from_raw(y_16), View::from_raw(z_16)}, projection);
}

RC_GTEST_PROP(PropertyProjection, FartherToTheRightIsNeverFartherLeftAndHigherNeverLower, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    // Pairs that lie together as often as pairs anywhere in view.
    const std::int64_t low = within(63 * z_16), step = *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const auto before = shown(projection, low, low, z_16), after = shown(projection, low + step, low + step, z_16);
    RC_ASSERT(before.x <= after.x);
    RC_ASSERT(before.y >= after.y);
}

RC_GTEST_PROP(PropertyProjection, FartherAwayIsNeverFartherFromTheCentre, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t farther_16 = z_16 + *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const std::int64_t x_16 = std::abs(within(64 * z_16)), y_16 = std::abs(within(64 * z_16));
    const auto near = shown(projection, x_16, y_16, z_16), far = shown(projection, x_16, y_16, farther_16);
    RC_ASSERT(near.x >= far.x && far.x >= projection.x.centre);
    RC_ASSERT(near.y <= far.y && far.y <= projection.y.centre);
    const auto near_left = shown(projection, -x_16, -y_16, z_16),
               far_left = shown(projection, -x_16, -y_16, farther_16);
    RC_ASSERT(near_left.x <= far_left.x && far_left.x <= projection.x.centre);
    RC_ASSERT(near_left.y >= far_left.y && far_left.y >= projection.y.centre);
}

/// Points that lie close to `view_16`, in their order from left to right, and the same on the other side of the middle.
void expect_order_around(const Projection& projection, std::int64_t view_16, std::int64_t z_16) {
    std::int64_t at_16 = view_16 - 80;
    for (int step = 0; step < 80; ++step) {
        const std::int64_t next_16 = at_16 + *rc::gen::inRange<std::int64_t>(0, 5);
        RC_ASSERT(shown(projection, at_16, 0, z_16).x <= shown(projection, next_16, 0, z_16).x);
        RC_ASSERT(shown(projection, -at_16, 0, z_16).x >= shown(projection, -next_16, 0, z_16).x);
        RC_ASSERT(shown(projection, 0, at_16, z_16).y >= shown(projection, 0, next_16, z_16).y);
        RC_ASSERT(shown(projection, 0, -at_16, z_16).y <= shown(projection, 0, -next_16, z_16).y);
        at_16 = next_16;
    }
}

RC_GTEST_PROP(PropertyProjection, ItNeverStepsBackWhereItsMultiplierBecomesExact, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    expect_order_around(projection, 64 * z_16, z_16);
}

RC_GTEST_PROP(PropertyProjection, ItDoesNotStepBackThoughItsMultiplierWasRoundedUpAsFarAsCanBe, ()) {
    // What is at 64 z then lies on a half of 1/256 pixel by the rounded multiplier, and before it by the exact one.
    Projection projection = any_lens();
    const std::int64_t coarse_16 = 4 * *rc::gen::inRange<std::int64_t>(1, 1 << 25) + 2;
    projection.x.coarse = projection.y.coarse = CoarseMultiplier::from_raw(coarse_16);
    projection.x.multiplier = projection.y.multiplier = Multiplier::from_raw(coarse_16 * 65536 - 32768);
    projection.x.fast_limit = projection.y.fast_limit = View::from_raw((std::int64_t{1} << 61) / (coarse_16 + 1));
    const std::int64_t z_16 = any_depth_16();
    expect_order_around(projection, 64 * z_16, z_16);
}

RC_GTEST_PROP(PropertyProjection, ItNeverStepsBackWhereItsProductBecomesWide, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    for (const ProjectionAxis& axis : {projection.x, projection.y})
        expect_order_around(projection, axis.fast_limit.raw, std::max(z_16, axis.fast_limit.raw / 64));
}

RC_GTEST_PROP(PropertyProjection, BeyondTheChangeItIsWithinItsBound, ()) {
    const Projection projection = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t x_16 = z_16 * *rc::gen::inRange<std::int64_t>(60, 70) + within(z_16);
    // |256 (x - centre) z 2^24 - multiplier x 2^32| in units of 2^-32 pixel times z: half of 1/256 pixel, and 64 2^-17.
    const auto offset_8 = static_cast<Int128>(shown(projection, x_16, 0, z_16).x.raw - projection.x.centre.raw);
    const Int128 error_32 = offset_8 * z_16 * (1 << 24) - static_cast<Int128>(projection.x.multiplier.raw) * x_16;
    const Int128 bound_32 =
        static_cast<Int128>(z_16) * ((1 << 23) + (std::int64_t{64} << 15) + (std::int64_t{8} << 15));
    RC_ASSERT(error_32 <= bound_32 && error_32 >= -bound_32);
}

}  // namespace
}  // namespace oblong::test
