#include "game/live_input.h"

#include <algorithm>
#include <limits>

namespace oblong {
namespace {

constexpr std::int32_t kKeyYaw = 728;    // 140 degrees a second
constexpr std::int32_t kKeyPitch = 520;  // 100 degrees a second
constexpr std::int32_t kMouseTurn = 12;  // a count of the mouse: 0.066 degrees
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

// Half a circle is more than a hand does between two ticks; a bound keeps hostile devices from overflowing.
std::int32_t turned(std::int32_t turn, std::int32_t counts) {
    return std::clamp(turn + std::clamp(counts, -4096, 4096) * -kMouseTurn, -65'536, 65'536);
}

std::int32_t part(std::int32_t value, std::int32_t fraction_16) {
    return static_cast<std::int32_t>(std::int64_t{value} * fraction_16 / 65'536);
}

}  // namespace

void LiveInput::gather(const Controls& controls) {
    held_ = controls;
    has_jumped_ |= controls.jump;
    mouse_yaw_ = turned(mouse_yaw_, controls.mouse_x);
    mouse_pitch_ = turned(mouse_pitch_, -std::clamp(controls.mouse_y, -4096, 4096));
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

ViewLead LiveInput::lead(std::int32_t fraction_16) const {
    const ViewLead keys = lead_of(
        {0, 0, static_cast<std::int16_t>(last_keys_.yaw), static_cast<std::int16_t>(last_keys_.pitch), 0}, fraction_16);
    return {keys.yaw + mouse_yaw_, keys.pitch + mouse_pitch_};
}

ViewLead lead_of(const TickInput& last, std::int32_t fraction_16) {
    return {-part(last.yaw, 65'536 - fraction_16), -part(last.pitch, 65'536 - fraction_16)};
}

}  // namespace oblong
