#include <algorithm>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

// Quake's numbers, in units and seconds.
constexpr World kGravity = World::from_int(800), kTopSpeed = World::from_int(320), kJumpSpeed = World::from_int(270);
constexpr World kStopSpeed = World::from_int(100), kAirWish = World::from_int(30), kSinkSpeed = World::from_int(60);
constexpr World kSwimUpSpeed = World::from_int(100), kLeaveWaterSpeed = World::from_int(310);
constexpr World kClimbSpeed = World::from_int(160);
constexpr World kRising = World::from_int(180);    // a player who rises faster is not on the ground
constexpr World kEyeSpeed = World::from_int(160);  // of the eye, after a step
constexpr std::int32_t kFriction = 4, kAccelerate = 10;

World in_a_tick(World per_second, std::int32_t factor = 1) {
    return scaled(per_second, factor, kTicksPerSecond);
}

void turn(Player& player, const TickInput& input) {
    player.yaw = player.yaw + Angle::from_bam(input.yaw);
    player.pitch = std::clamp(player.pitch + input.pitch, -Player::kSteepestPitch, Player::kSteepestPitch);
}

constexpr std::int32_t kAboveFeet = -23;

Depth depth_at(const GameLevel& level, const Position& position) {
    const auto is_wet = [&](std::int32_t z) {
        const std::int32_t filling = contents_at(level, position + world_vector(0, 0, z));
        return filling == contents::kWater || filling == contents::kSlime || filling == contents::kLava;
    };
    if (!is_wet(kAboveFeet)) return Depth::Dry;
    if (!is_wet(4)) return Depth::Feet;
    return is_wet(kEyeHeight) ? Depth::Eyes : Depth::Waist;
}

// Friction is proportional to the speed, but at least that of the speed `at_least`, so that the player comes to rest.
Velocity with_friction(const Velocity& v, World at_least) {
    const World speed = length_of(v);
    if (speed == World{}) return v;
    const World loss = in_a_tick(std::max(speed, at_least), kFriction);
    return scaled(v, std::max(World{}, speed - loss), speed);
}

// Accelerates in the direction of the wish by an amount proportional to the wish, up to `most` in that direction.
Velocity accelerated(const Velocity& v, const Velocity& wish, World most) {
    const World wished = length_of(wish);
    if (wished == World{}) return v;
    const World already = truncated_quotient<World>(dot(v, wish), wished);
    const World missing = std::min(most, wished) - already;
    if (missing <= World{}) return v;
    return v + scaled(wish, std::min(missing, in_a_tick(wished, kAccelerate)), wished);
}

// The velocity that the input asks for, at most kTopSpeed: horizontal when walking, along the view when swimming.
Velocity wish_of(const Player& player, const TickInput& input, bool swims) {
    const Angle pitch = Angle::from_bam(swims ? player.pitch : 0);
    const Unit cos_yaw = cosine(player.yaw), sin_yaw = sine(player.yaw);
    const World forward = scaled(kTopSpeed, input.forward, 127), right = scaled(kTopSpeed, input.right, 127);
    const World level = times(forward, cosine(pitch));
    const Velocity wish{times(level, cos_yaw) + times(right, sin_yaw), times(level, sin_yaw) - times(right, cos_yaw),
                        times(-forward, sine(pitch))};
    const World speed = length_of(wish);
    return speed > kTopSpeed ? scaled(wish, kTopSpeed, speed) : wish;
}

// True if a wall ahead ends just above the water: Quake's jump out of water.
bool can_leave_water(const GameLevel& level, const Player& player, const TickInput& input) {
    if (player.depth != Depth::Waist || input.forward <= 0) return false;
    const Vec3<World> ahead = times(World::from_int(24), {cosine(player.yaw), sine(player.yaw), Unit{}});
    const Position wall = player.position + ahead + world_vector(0, 0, 8);
    return contents_at(level, wall) == contents::kSolid &&
           contents_at(level, wall + world_vector(0, 0, 24)) == contents::kEmpty;
}

void swim(const GameLevel& level, GameState& state, const TickInput& input) {
    Player& player = state.player;
    Velocity wish = wish_of(player, input, true);
    const bool jumps = (input.buttons & kJumpButton) != 0;
    if (wish == Velocity{} && !jumps) wish.z = -kSinkSpeed;
    wish = scaled(wish, 7, 10);
    Velocity velocity = accelerated(with_friction(player.velocity, World{}), wish, kTopSpeed);
    if (jumps) velocity.z = std::max(velocity.z, kSwimUpSpeed);
    if (can_leave_water(level, player, input)) velocity.z = kLeaveWaterSpeed;
    const Motion after = step_slide_move(level, state, {player.position, bounded(velocity)});
    player.position = after.position;
    player.velocity = after.velocity;
    player.ground = Player::kNoGround;
}

// Whether what the player wants leads up a ladder from the ground.
bool climbs_up(const Player& player, const TickInput& input) {
    return (input.buttons & kJumpButton) != 0 || wish_of(player, input, true).z > kSinkSpeed;
}

// Rubicon 2's ladder, on which who does nothing stays where he is; here it leads along the view, too.
void climb(const GameLevel& level, GameState& state, const TickInput& input) {
    Player& player = state.player;
    const Velocity wish = wish_of(player, input, true);
    Velocity velocity = accelerated(with_friction(player.velocity, kStopSpeed), {wish.x, wish.y, World{}}, kTopSpeed);
    player.holds_jump = (input.buttons & kJumpButton) != 0;
    velocity.z = player.holds_jump ? kClimbSpeed : std::clamp(wish.z, -kClimbSpeed, kClimbSpeed);
    const Motion after = slide_move(level, state, {player.position, bounded(velocity)});
    player.position = after.position;
    player.velocity = after.velocity;
    player.ground = Player::kNoGround;
}

void fly(const GameLevel& level, GameState& state, const TickInput& input) {
    Player& player = state.player;
    Velocity velocity = accelerated(player.velocity, wish_of(player, input, false), kAirWish);
    velocity.z -= in_a_tick(kGravity);
    const Motion after = slide_move(level, state, {player.position, bounded(velocity)});
    player.position = after.position;
    player.velocity = after.velocity;
}

void walk(const GameLevel& level, GameState& state, const TickInput& input) {
    Player& player = state.player;
    player.velocity.z = World{};
    const Velocity velocity =
        accelerated(with_friction(player.velocity, kStopSpeed), wish_of(player, input, false), kTopSpeed);
    if (velocity == Velocity{}) {
        player.velocity = velocity;
        return;
    }
    const World height_before = player.position.z;
    const Motion after = step_slide_move(level, state, {player.position, bounded(velocity)});
    const Contact ground = find_ground(level, state, after.position, World::from_int(kStepHeight));
    player.position = ground.has_hit ? ground.end : after.position;  // follows the ground down a step, too
    player.velocity = after.velocity;
    player.eye_lag += player.position.z - height_before;
}

void find_footing(const GameLevel& level, GameState& state) {
    Player& player = state.player;
    player.ground = Player::kNoGround;
    if (player.velocity.z > kRising) return;
    const Contact below = find_ground(level, state, player.position, World::from_int(1));
    if (!below.has_hit) return;
    player.ground = below.model.number();
    player.position = below.end;
}

void jump(Player& player, const TickInput& input) {
    const bool wants = (input.buttons & kJumpButton) != 0;
    if (wants && !player.holds_jump && player.ground != Player::kNoGround) {
        player.velocity.z += kJumpSpeed;
        player.ground = Player::kNoGround;
    }
    player.holds_jump = wants;
}

void raise_eye(Player& player) {
    const World most = World::from_int(kStepHeight), step = in_a_tick(kEyeSpeed);
    player.eye_lag = std::clamp(player.eye_lag, -most, most);
    player.eye_lag -= std::clamp(player.eye_lag, -step, step);
}

// A player in something solid is moved up by at most a step. A player inside a brush model (where a teleporter's exit
// or the start is inside a mover) is moved out by the shortest way, or to the start if there is none.
void leave_solid(const GameLevel& level, GameState& state) {
    Player& player = state.player;
    for (std::int32_t up = 0; up <= kStepHeight; ++up) {
        const Position position = player.position + world_vector(0, 0, up);
        if (!is_free(level, state, position)) continue;
        player.position = position;
        return;
    }
    const WayOut out = find_way_out(level, state, player.position);
    if (out.is_inside_model) player.position = out.position.value_or(level.start.position);
}

}  // namespace

Position eye_of(const Player& player) {
    return player.position + Vec3<World>{World{}, World{}, World::from_int(kEyeHeight) - player.eye_lag};
}

bool was_teleported(const Player& before, const Player& after) {
    static constexpr World kLongestMotion = World::from_int(128);
    return !is_within(eye_of(after) - eye_of(before), kLongestMotion);
}

void hurt_in_liquid(const GameLevel& level, GameState& state) {
    const std::int32_t liquid = contents_at(level, state.player.position + world_vector(0, 0, kAboveFeet));
    const auto depth = static_cast<std::int32_t>(state.player.depth);
    if (liquid == contents::kLava && state.tick % (kTicksPerSecond / 5) == 0) hurt(level, state, 10 * depth);
    if (liquid == contents::kSlime && state.tick % kTicksPerSecond == 0) hurt(level, state, 4 * depth);
}

void step_player(const GameLevel& level, GameState& state, const TickInput& input) {
    Player& player = state.player;
    turn(player, input);
    leave_solid(level, state);
    player.depth = depth_at(level, player.position);
    if (player.depth >= Depth::Waist) {
        swim(level, state, input);
    } else {
        find_footing(level, state);
        const bool is_up = player.ground == Player::kNoGround;
        if ((is_up || climbs_up(player, input)) && is_on_ladder(level, state)) {
            climb(level, state, input);
            return raise_eye(player);
        }
        jump(player, input);
        if (player.ground == Player::kNoGround)
            fly(level, state, input);
        else
            walk(level, state, input);
    }
    raise_eye(player);
}

}  // namespace oblong
