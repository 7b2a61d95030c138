#include "game/player.h"

#include <algorithm>

#include "engine/fixed/trig.h"
#include "game/collision.h"
#include "game/glide.h"
#include "game/velocity.h"

namespace oblong {
namespace {

// Quake's numbers, in units and seconds.
constexpr World kGravity = World::from_int(800), kTopSpeed = World::from_int(320), kJumpSpeed = World::from_int(270);
constexpr World kStopSpeed = World::from_int(100), kAirWish = World::from_int(30), kSinkSpeed = World::from_int(60);
constexpr World kSwimUpSpeed = World::from_int(100), kLeaveWaterSpeed = World::from_int(310);
constexpr World kFastest = World::from_int(2000);      // in each axis
constexpr World kStillRising = World::from_int(180);   // nobody stands on ground that they leave so fast
constexpr World kEyeCatchesUp = World::from_int(160);  // after a step
constexpr std::int32_t kFriction = 4, kAccelerate = 10;

World in_a_tick(World per_second, std::int32_t times = 1) {
    return World::from_raw(static_cast<std::int32_t>(std::int64_t{per_second.raw} * times / kTicksPerSecond));
}

void turn(Player& player, const TickInput& input) {
    player.yaw = player.yaw + Angle::from_bam(input.yaw);
    player.pitch = std::clamp(player.pitch + input.pitch, -Player::kSteepestPitch, Player::kSteepestPitch);
}

Depth depth_at(const Stage& stage, const Place& place) {
    const auto is_wet = [&](std::int32_t z) {
        const std::int32_t filling = contents_at(stage, place + place_of(0, 0, z));
        return filling == contents::kWater || filling == contents::kSlime || filling == contents::kLava;
    };
    if (!is_wet(-23)) return Depth::Dry;
    if (!is_wet(4)) return Depth::Feet;
    return is_wet(kEyeHeight) ? Depth::Eyes : Depth::Waist;
}

// What slows the player: on the ground at least as much as at kStopSpeed, so that it ends.
Velocity with_friction(const Velocity& v, World at_least) {
    const World speed = length_of(v);
    if (speed == World{}) return v;
    const World loss = in_a_tick(std::max(speed, at_least), kFriction);
    return scaled(v, std::max(World{}, speed - loss), speed);
}

// Adds speed in the direction of the wish, up to `most` in that direction, by as much as the whole wish allows.
Velocity accelerated(const Velocity& v, const Velocity& wish, World most) {
    const World wished = length_of(wish);
    if (wished == World{}) return v;
    const World already = World::from_raw(static_cast<std::int32_t>(
        (std::int64_t{v.x.raw} * wish.x.raw + std::int64_t{v.y.raw} * wish.y.raw + std::int64_t{v.z.raw} * wish.z.raw) /
        wished.raw));
    const World missing = std::min(most, wished) - already;
    if (missing <= World{}) return v;
    return v + scaled(wish, std::min(missing, in_a_tick(wished, kAccelerate)), wished);
}

Velocity bounded(const Velocity& v) {
    const auto bound = [](World w) { return std::clamp(w, -kFastest, kFastest); };
    return {bound(v.x), bound(v.y), bound(v.z)};
}

// The velocity that the keys ask for, no faster than kTopSpeed. Level for one who walks, along the view for a swimmer.
Velocity wish_of(const Player& player, const TickInput& input, bool swims) {
    const Angle pitch = Angle::from_bam(swims ? player.pitch : 0);
    const Unit ahead_flat = cosine(pitch), cos_yaw = cosine(player.yaw), sin_yaw = sine(player.yaw);
    const auto along = [](std::int32_t part_127, Unit direction) {
        return convert<World>(widening_product(World::from_raw(kTopSpeed.raw * part_127 / 127), direction));
    };
    const World flat = along(input.forward, ahead_flat), right = World::from_raw(kTopSpeed.raw * input.right / 127);
    const auto times = [](World w, Unit direction) { return convert<World>(widening_product(w, direction)); };
    const Velocity wish{times(flat, cos_yaw) + times(right, sin_yaw), times(flat, sin_yaw) - times(right, cos_yaw),
                        along(-input.forward, sine(pitch))};
    const World speed = length_of(wish);
    return speed > kTopSpeed ? scaled(wish, kTopSpeed, speed) : wish;
}

// A wall ahead that ends just above the water: Quake's way out of it.
bool can_leave_water(const Stage& stage, const Player& player, const TickInput& input) {
    if (player.depth != Depth::Waist || input.forward <= 0) return false;
    const auto ahead = [](Unit part) { return convert<World>(widening_product(World::from_int(24), part)); };
    const Place wall = player.place + Place{ahead(cosine(player.yaw)), ahead(sine(player.yaw)), World::from_int(8)};
    return contents_at(stage, wall) == contents::kSolid &&
           contents_at(stage, wall + place_of(0, 0, 24)) == contents::kEmpty;
}

void swim(const Stage& stage, GameState& state, const TickInput& input) {
    Player& player = state.player;
    Velocity wish = wish_of(player, input, true);
    const bool jumps = (input.buttons & kJumpButton) != 0;
    if (wish == Velocity{} && !jumps) wish.z = -kSinkSpeed;
    wish = scaled(wish, World::from_int(7), World::from_int(10));
    Velocity velocity = accelerated(with_friction(player.velocity, World{}), wish, kTopSpeed);
    if (jumps) velocity.z = std::max(velocity.z, kSwimUpSpeed);
    if (can_leave_water(stage, player, input)) velocity.z = kLeaveWaterSpeed;
    const Motion after = glide_over_steps(stage, state, {player.place, bounded(velocity)});
    player.place = after.place;
    player.velocity = after.velocity;
    player.ground = Player::kNoGround;
}

void fly(const Stage& stage, GameState& state, const TickInput& input) {
    Player& player = state.player;
    Velocity velocity = accelerated(player.velocity, wish_of(player, input, false), kAirWish);
    velocity.z -= in_a_tick(kGravity);
    const Motion after = glide(stage, state, {player.place, bounded(velocity)});
    player.place = after.place;
    player.velocity = after.velocity;
}

void walk(const Stage& stage, GameState& state, const TickInput& input) {
    Player& player = state.player;
    player.velocity.z = World{};
    const Velocity velocity =
        accelerated(with_friction(player.velocity, kStopSpeed), wish_of(player, input, false), kTopSpeed);
    if (velocity == Velocity{}) {
        player.velocity = velocity;
        return;
    }
    const World height_before = player.place.z;
    const Motion after = glide_over_steps(stage, state, {player.place, bounded(velocity)});
    const Contact ground = find_ground(stage, state, after.place, World::from_int(kStepHeight));
    player.place = ground.has_hit ? ground.end : after.place;  // down a step, too
    player.velocity = after.velocity;
    player.eye_lag += player.place.z - height_before;
}

void find_footing(const Stage& stage, GameState& state) {
    Player& player = state.player;
    player.ground = Player::kNoGround;
    if (player.velocity.z > kStillRising) return;
    const Contact below = find_ground(stage, state, player.place, World::from_int(1));
    if (!below.has_hit) return;
    player.ground = below.model.number();
    player.place = below.end;
}

void jump(Player& player, const TickInput& input) {
    const bool wants = (input.buttons & kJumpButton) != 0;
    if (wants && !player.holds_jump && player.ground != Player::kNoGround) {
        player.velocity.z += kJumpSpeed;
        player.ground = Player::kNoGround;
    }
    player.holds_jump = wants;
}

void let_eye_catch_up(Player& player) {
    const World most = World::from_int(kStepHeight), step = in_a_tick(kEyeCatchesUp);
    player.eye_lag = std::clamp(player.eye_lag, -most, most);
    player.eye_lag -= std::clamp(player.eye_lag, -step, step);
}

// One who stands in something solid (a start too low, a lift from below) is lifted out where that is near.
void free_from_solid(const Stage& stage, GameState& state) {
    for (std::int32_t up = 0; up <= kStepHeight; ++up) {
        const Place place = state.player.place + place_of(0, 0, up);
        if (!is_free(stage, state, place)) continue;
        state.player.place = place;
        return;
    }
}

}  // namespace

void step_player(const Stage& stage, GameState& state, const TickInput& input) {
    Player& player = state.player;
    turn(player, input);
    free_from_solid(stage, state);
    player.depth = depth_at(stage, player.place);
    if (player.depth >= Depth::Waist) {
        swim(stage, state, input);
    } else {
        find_footing(stage, state);
        jump(player, input);
        if (player.ground == Player::kNoGround)
            fly(stage, state, input);
        else
            walk(stage, state, input);
    }
    let_eye_catch_up(player);
}

}  // namespace oblong
