#include "game/tick_input_source.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/input_error.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::int32_t kKeyYaw = 728;    // 140 degrees a second
constexpr std::int32_t kKeyPitch = 520;  // 100 degrees a second
constexpr std::int32_t kMouseTurn = 12;  // a count of the mouse: 0.066 degrees
constexpr std::int32_t kMostCounts = 4096;
constexpr int kFullSpeed = 127, kSlowSpeed = 56;

int direction(bool positive, bool negative) {
    return int{positive} - int{negative};
}

// As much of a turn as fits a tick; the rest stays.
std::int16_t take_turn(std::int32_t& turn) {
    const std::int32_t taken = std::clamp<std::int32_t>(turn, -std::numeric_limits<std::int16_t>::max(),
                                                        std::numeric_limits<std::int16_t>::max());
    turn -= taken;
    return static_cast<std::int16_t>(taken);
}

// Bounded, so that no device makes the sum overflow; half a circle is more than a mouse turns between two ticks.
std::int32_t turned(std::int32_t turn, std::int32_t counts) {
    return std::clamp(turn - std::clamp(counts, -kMostCounts, kMostCounts) * kMouseTurn, -65'536, 65'536);
}

// The part of a tick's turn that is not yet drawn, to be taken back.
LookOffset rest_of(std::int32_t yaw, std::int32_t pitch, std::int32_t fraction_16) {
    const auto rest = [&](std::int32_t turn) {
        return -static_cast<std::int32_t>(std::int64_t{turn} * (65'536 - fraction_16) / 65'536);
    };
    return {rest(yaw), rest(pitch)};
}

}  // namespace

void LiveInput::gather(const Controls& controls) {
    held_ = controls;
    has_jumped_ |= controls.jump;
    mouse_yaw_ = turned(mouse_yaw_, controls.mouse_x);
    mouse_pitch_ = turned(mouse_pitch_, -std::max(controls.mouse_y, -kMostCounts));
}

TickInput LiveInput::next() {
    const int speed = held_.walk_slowly ? kSlowSpeed : kFullSpeed;
    last_keys_ = {kKeyYaw * direction(held_.turn_left, held_.turn_right),
                  kKeyPitch * direction(held_.look_down, held_.look_up)};
    mouse_yaw_ += last_keys_.yaw;
    mouse_pitch_ += last_keys_.pitch;

    TickInput input;
    input.forward = static_cast<std::int8_t>(speed * direction(held_.forward, held_.back));
    input.right = static_cast<std::int8_t>(speed * direction(held_.right, held_.left));
    input.yaw = take_turn(mouse_yaw_);
    input.pitch = take_turn(mouse_pitch_);
    input.buttons = has_jumped_ ? kJumpButton : std::uint8_t{0};
    has_jumped_ = held_.jump;  // a key let go since then still jumps once
    return input;
}

LookOffset LiveInput::look_offset(std::int32_t fraction_16) const {
    const LookOffset keys = rest_of(last_keys_.yaw, last_keys_.pitch, fraction_16);
    return {keys.yaw + mouse_yaw_, keys.pitch + mouse_pitch_};
}

TickInputSource::TickInputSource(const GameState& start, std::optional<Demo> replayed, bool records)
    : replayed_(std::move(replayed)), records_(records) {
    recorded_.start_hash = hash_of(start);
    if (replayed_ && replayed_->start_hash != recorded_.start_hash)
        throw InputError("start", "recorded on another level, expected this one's");
}

void TickInputSource::play_tick(const GameLevel& level, GameState& state) {
    was_replayed_ = is_replaying();
    last_ = was_replayed_ ? replayed_->ticks[next_].input : live_.next();
    step(level, state, last_);
    if (!was_replayed_ && !records_) return;
    const std::uint64_t hash = hash_of(state);
    if (records_) recorded_.ticks.push_back({last_, hash});
    if (was_replayed_ && replayed_->ticks[next_++].state_hash != hash)
        throw InputError("tick " + std::to_string(next_), "leads to another state than when it was recorded");
}

LookOffset TickInputSource::look_offset(std::int32_t fraction_16) const {
    return was_replayed_ ? rest_of(last_.yaw, last_.pitch, fraction_16) : live_.look_offset(fraction_16);
}

}  // namespace oblong
