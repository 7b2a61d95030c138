// Projection never turns the order of points round.

#include "engine/screen/projection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/geometry/project.h"

namespace oblong::test {
namespace {

/// Of a mode and a field of view that leaves what is on the screen within 64 z of the middle, as project_axis_8() says.
Projection any_lens() {
    ScreenMode mode;
    mode.width_px = *rc::gen::inRange(16, 2'048);
    mode.height_px = *rc::gen::inRange(16, 2'048);
    return make_projection(mode, Degrees::from_int(*rc::gen::inRange(1, 179)));
}

/// From the near plane to the far end of the world, evenly over its powers of two.
std::int64_t any_depth_16() {
    return *rc::gen::inRange<std::int64_t>(4, 8) << *rc::gen::inRange(0, 29);
}

/// Between -limit and limit.
std::int64_t within(std::int64_t limit) {
    return *rc::gen::inRange<std::int64_t>(-limit, limit + 1);
}

ScreenPosition shown(const Projection& lens, std::int64_t x_16, std::int64_t y_16, std::int64_t z_16) {
    return project({View::from_raw(x_16), View::from_raw(y_16), View::from_raw(z_16)}, lens);
}

RC_GTEST_PROP(PropertyProjection, FartherToTheRightIsNeverFartherLeftAndHigherNeverLower, ()) {
    const Projection lens = any_lens();
    const std::int64_t z_16 = any_depth_16();
    // Pairs that lie together as often as pairs anywhere in view.
    const std::int64_t low = within(63 * z_16), step = *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const auto before = shown(lens, low, low, z_16), after = shown(lens, low + step, low + step, z_16);
    RC_ASSERT(before.x <= after.x);
    RC_ASSERT(before.y >= after.y);
}

RC_GTEST_PROP(PropertyProjection, FartherAwayIsNeverFartherFromTheCentre, ()) {
    const Projection lens = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t farther_16 = z_16 + *rc::gen::element<std::int64_t>(1, 16, z_16 / 256, z_16);
    const std::int64_t x_16 = std::abs(within(64 * z_16)), y_16 = std::abs(within(64 * z_16));
    const auto near = shown(lens, x_16, y_16, z_16), far = shown(lens, x_16, y_16, farther_16);
    RC_ASSERT(near.x >= far.x && far.x >= lens.x.centre);
    RC_ASSERT(near.y <= far.y && far.y <= lens.y.centre);
    const auto near_left = shown(lens, -x_16, -y_16, z_16), far_left = shown(lens, -x_16, -y_16, farther_16);
    RC_ASSERT(near_left.x <= far_left.x && far_left.x <= lens.x.centre);
    RC_ASSERT(near_left.y >= far_left.y && far_left.y >= lens.y.centre);
}

RC_GTEST_PROP(PropertyProjection, WhereItChangesItsMethodItStepsBackByNoMoreThanItsLastBit, ()) {
    const Projection lens = any_lens();
    const std::int64_t z_16 = any_depth_16();
    const std::int64_t seam = 64 * z_16 + *rc::gen::inRange<std::int64_t>(-70, 70);
    const auto before = shown(lens, seam, 0, z_16), after = shown(lens, seam + 1, 0, z_16);
    RC_ASSERT(after.x.raw >= before.x.raw - 1);
}

}  // namespace
}  // namespace oblong::test
