#include <algorithm>

#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "game/view/shown_view.h"

namespace oblong {
namespace {

constexpr std::int64_t kCycle_ticks = 21;  // 0.6 s
static_assert(kCycle_ticks * 10 == 6 * kTicksPerSecond);
constexpr World kHighest = World::from_int(4), kLowest = World::from_int(-7);
constexpr World kLeanSpeed = World::from_int(200);  // at which the lean is kLean
constexpr std::int64_t kLean = 364;                 // 2 degrees, 65,536 to the circle

Velocity velocity_at(const InterpolatedState& state) {
    const Velocity &before = state.before.player.velocity, &after = state.after.player.velocity;
    return before + scaled(after - before, state.fraction_16, 65'536);
}

// 0.02 s times the speed: three tenths constant, seven tenths times a sine.
World bob(World speed, const InterpolatedState& state) {
    const std::int64_t ticks_16 = (state.before.tick % kCycle_ticks << 16) + state.fraction_16;
    const Unit wave = sine(Angle::from_bam(ticks_16 / kCycle_ticks));
    const World most = scaled(speed, 2, 100);
    return std::clamp(scaled(most, 3, 10) + times(scaled(most, 7, 10), wave), kLowest, kHighest);
}

std::int64_t lean(World sideways) {
    return std::int64_t{floor_of<12>(std::clamp(sideways, -kLeanSpeed, kLeanSpeed))} * kLean / floor_of<12>(kLeanSpeed);
}

}  // namespace

void sway(const InterpolatedState& state, const ComfortPreferences& preferences, Camera& camera) {
    Velocity velocity = velocity_at(state);
    velocity.z = {};
    if (preferences.view_bob_100 != 0)
        camera.eye.z = camera.eye.z + scaled(bob(length_of(velocity), state), preferences.view_bob_100, 100);
    if (preferences.view_roll_100 == 0) return;
    const World sideways = component_along(velocity, view_basis(camera.yaw, {}, {}).right);
    camera.roll = Angle::from_bam(lean(sideways) * preferences.view_roll_100 / 100);
}

}  // namespace oblong
