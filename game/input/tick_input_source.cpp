#include "game/input/tick_input_source.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/fixed/root.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::int64_t kFullReach = std::int64_t{kFullAxis} * 97 / 100;

std::int64_t length_of(Stick stick) {
    const std::int64_t x = stick.x, y = stick.y;
    return static_cast<std::int64_t>(integer_root(static_cast<std::uint64_t>(x * x + y * y)));
}

Stick scaled(Stick stick, std::int64_t numerator, std::int64_t denominator) {
    return {static_cast<std::int32_t>(stick.x * numerator / denominator),
            static_cast<std::int32_t>(stick.y * numerator / denominator)};
}

// Turns in a tick.
constexpr std::int32_t kKeyYaw = 728;      // 140 degrees a second
constexpr std::int32_t kKeyPitch = 520;    // 100 degrees a second
constexpr std::int32_t kStickYaw = 1040;   // 200 degrees a second, with the stick fully pushed
constexpr std::int32_t kStickPitch = 624;  // 120 degrees a second
constexpr std::int32_t kMouseTurn = 12;    // a count of the mouse: 0.066 degrees
constexpr std::int32_t kMostCounts = 4096;
constexpr int kFullSpeed = 127, kSlowSpeed = 56;

// The speed from a key's direction (-1 to 1) and a stick.
std::int8_t speed_of(int key, std::int32_t stick, bool is_slow) {
    const int most = is_slow ? kSlowSpeed : kFullSpeed;
    return static_cast<std::int8_t>(std::clamp(key * most + stick * most / kFullAxis, -most, most));
}

std::int32_t turn_of(std::int32_t stick, std::int32_t full_turn, std::int32_t sensitivity_100) {
    return static_cast<std::int32_t>(std::int64_t{stick} * full_turn * sensitivity_100 / (100 * kFullAxis));
}

// Takes as much of a turn as fits into a tick.
std::int16_t take_turn(std::int32_t& turn) {
    const std::int32_t taken = std::clamp<std::int32_t>(turn, -std::numeric_limits<std::int16_t>::max(),
                                                        std::numeric_limits<std::int16_t>::max());
    turn -= taken;
    return static_cast<std::int16_t>(taken);
}

// Adds a turn of the mouse. The sum is bounded so that no device makes it overflow.
void add_turn(std::int32_t& turn, std::int32_t& rest_100, std::int32_t counts, std::int32_t sensitivity_100) {
    constexpr std::int32_t kMost = 65'536;
    const std::int32_t turn_100 =
        std::clamp(counts, -kMostCounts, kMostCounts) * kMouseTurn * sensitivity_100 + rest_100;
    turn = std::clamp(turn + turn_100 / 100, -kMost, kMost);
    rest_100 = turn_100 % 100;
}

// The part of a tick's turn that is not yet drawn, negated.
LookOffset rest_of(std::int32_t yaw, std::int32_t pitch, std::int32_t fraction_16) {
    const auto rest = [&](std::int32_t turn) {
        return -static_cast<std::int32_t>(std::int64_t{turn} * (65'536 - fraction_16) / 65'536);
    };
    return {rest(yaw), rest(pitch)};
}

}  // namespace

Stick without_dead_zone(Stick stick, std::int32_t dead_zone_100) {
    const std::int64_t length = length_of(stick), dead = std::int64_t{kFullAxis} * dead_zone_100 / 100;
    if (length <= dead) return {};
    if (length >= kFullReach) return scaled(stick, std::max<std::int64_t>(length, kFullAxis), length);
    return scaled(stick, (length - dead) * kFullAxis, (kFullReach - dead) * length);
}

Stick squared(Stick stick) {
    return scaled(stick, std::min<std::int64_t>(length_of(stick), kFullAxis), kFullAxis);
}

void LiveInput::gather(const Controls& controls) {
    held_ = controls.moves;
    walk_stick_ = controls.walk_stick;
    look_stick_ = controls.look_stick;
    tapped_ |= controls.moves;
    wants_respawn_ |= controls.has(Action::Respawn);
    add_turn(mouse_yaw_, rest_yaw_100_, -std::max(controls.mouse_x, -kMostCounts), steering_.mouse_sensitivity_100);
    const std::int32_t down = std::max(controls.mouse_y, -kMostCounts);
    add_turn(mouse_pitch_, rest_pitch_100_, steering_.inverts_look ? -down : down, steering_.mouse_sensitivity_100);
}

TickInput LiveInput::next() {
    // A key pressed and released between two ticks counts once.
    Moves moves = held_;
    moves |= std::exchange(tapped_, {}).without(held_before_);
    held_before_ = held_;
    last_turn_ = turn_by(moves);
    mouse_yaw_ += last_turn_.yaw;
    mouse_pitch_ += last_turn_.pitch;

    const bool is_slow = moves.has(Action::WalkSlowly) == steering_.always_runs;
    const Stick stick = without_dead_zone(walk_stick_, steering_.gamepad_dead_zone_100);
    TickInput input;
    input.forward = speed_of(moves.direction(Action::Forward, Action::Back), stick.y, is_slow);
    input.right = speed_of(moves.direction(Action::Right, Action::Left), stick.x, is_slow);
    input.yaw = take_turn(mouse_yaw_);
    input.pitch = take_turn(mouse_pitch_);
    if (moves.has(Action::Jump)) input.buttons |= kJumpButton;
    if (std::exchange(wants_respawn_, false)) input.buttons |= kRespawnButton;
    if (std::exchange(wants_visit_, false)) input.buttons |= kVisitButton;
    input.view = view_;
    input.work = work_;
    return input;
}

LookOffset LiveInput::turn_by(Moves moves) const {
    const Stick stick = squared(without_dead_zone(look_stick_, steering_.gamepad_dead_zone_100));
    const std::int32_t down = steering_.inverts_look ? stick.y : -stick.y;
    return {kKeyYaw * moves.direction(Action::TurnLeft, Action::TurnRight) -
                turn_of(stick.x, kStickYaw, steering_.gamepad_sensitivity_100),
            kKeyPitch * moves.direction(Action::LookDown, Action::LookUp) +
                turn_of(down, kStickPitch, steering_.gamepad_sensitivity_100)};
}

LookOffset LiveInput::look_offset(std::int32_t fraction_16) const {
    const LookOffset turn = rest_of(last_turn_.yaw, last_turn_.pitch, fraction_16);
    return {turn.yaw + mouse_yaw_, turn.pitch + mouse_pitch_};
}

TickInputSource::TickInputSource(const GameState& start, std::optional<Demo> replayed, bool records,
                                 std::uint64_t rules_hash)
    : replayed_(std::move(replayed)), records_(records) {
    recorded_.start_hash = start_hash_of(start, rules_hash);
    if (replayed_ && replayed_->start_hash != recorded_.start_hash)
        throw InputError("start", "recorded on another level or by other rules, expected this one's");
}

TickReport TickInputSource::play_tick(const GameLevel& level, GameState& state) {
    was_replayed_ = is_replaying();
    last_ = was_replayed_ ? replayed_->ticks[next_].input : live_.next();
    const bool is_over = state.has_ended;
    const TickReport report = step(level, state, last_);
    if (!was_replayed_ && !records_) return report;
    const std::uint64_t hash = hash_of(state);
    if (records_ && !is_over) recorded_.ticks.push_back({last_, hash});
    if (was_replayed_ && replayed_->ticks[next_++].state_hash != hash)
        throw InputError("tick " + std::to_string(next_), "leads to another state, expected the recorded one");
    return report;
}

LookOffset TickInputSource::look_offset(std::int32_t fraction_16) const {
    return was_replayed_ ? rest_of(last_.yaw, last_.pitch, fraction_16) : live_.look_offset(fraction_16);
}

}  // namespace oblong
