#pragma once

#include <algorithm>
#include <cmath>

#include "game/simulation/tick.h"
#include "tests/controls/virtual_pad.h"

namespace oblong::test {

/// Holds a virtual pad's sticks and buttons so that the game makes of them a given input of a tick: with the default
/// bindings and preferences, and turns that a stick can make (1040 of 65,536 sideways, 624 up or down).
class PadPilot {
  public:
    explicit PadPilot(VirtualPad& pad) : pad_(pad) {}

    void steer(const TickInput& input) {
        const Place walk = pushed({middle_of(input.right, 127), middle_of(input.forward, 127)});
        pad_.set(PadAxis::LeftX, axis(walk.x));
        pad_.set(PadAxis::LeftY, axis(-walk.y));
        const Place look = pushed(unsquared({middle_of(-input.yaw, 1040), middle_of(input.pitch, 624)}));
        pad_.set(PadAxis::RightX, axis(look.x));
        pad_.set(PadAxis::RightY, axis(look.y));
        hold(PadButton::A, (input.buttons & kJumpButton) != 0);
        hold(PadButton::Y, (input.buttons & kRespawnButton) != 0);
    }

  private:
    struct Place {
        double x, y;  // 1: the full way
    };

    // The middle of what is rounded to `value` of `full`.
    static double middle_of(int value, int full) {
        if (value == 0) return 0;
        return std::copysign(std::min((std::abs(value) + 0.5) / full, 1.0), value);
    }
    static Place unsquared(Place place) {
        const double length = std::hypot(place.x, place.y);
        return length > 0 ? Place{place.x / std::sqrt(length), place.y / std::sqrt(length)} : place;
    }
    // Past a dead zone of 15 %; the full length is at 97 %.
    static Place pushed(Place place) {
        const double length = std::hypot(place.x, place.y);
        if (length == 0 || length >= 1) return place;
        const double pushed = 0.15 + length * (0.97 - 0.15);
        return {place.x / length * pushed, place.y / length * pushed};
    }
    static std::int32_t axis(double place) { return static_cast<std::int32_t>(std::lround(place * kFullAxis)); }
    void hold(PadButton button, bool is_held) { is_held ? pad_.press(button) : pad_.release(button); }

    VirtualPad& pad_;
};

}  // namespace oblong::test
