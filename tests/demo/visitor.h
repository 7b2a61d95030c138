#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "game/simulation/step.h"
#include "tests/support/point.h"

namespace oblong::test {

/// A point to walk to, and how high the player's middle must be before the visit goes on (a lift takes its time).
struct Waypoint {
    double x, y;
    double least_z = -1000;
};

/// A visitor who turns towards the next waypoint at once and walks.
class Visitor {
  public:
    explicit Visitor(const Level& level) : level_(make_game_level(level)), state_(start_of(level_)) {}

    const GameState& state() const { return state_; }

    /// False if the waypoint is not reached in half a minute of game time.
    bool walk_to(const Waypoint& waypoint) {
        for (std::int64_t tick = 0; tick < 30 * kTicksPerSecond && !state_.has_ended; ++tick) {
            const double dx = waypoint.x - number_of(state_.player.position.x),
                         dy = waypoint.y - number_of(state_.player.position.y);
            const bool is_there = std::hypot(dx, dy) < 14;
            if (is_there && number_of(state_.player.position.z) >= waypoint.least_z) return true;
            step(level_, state_, is_there ? TickInput{} : step_towards(dx, dy));
        }
        return state_.has_ended;
    }

    /// To each of them in turn.
    void walk(const std::vector<Waypoint>& route) {
        for (const Waypoint& waypoint : route) {
            const Position& position = state_.player.position;
            ASSERT_TRUE(walk_to(waypoint))
                << "stuck at " << number_of(position.x) << ' ' << number_of(position.y) << ' ' << number_of(position.z)
                << " on the way to " << waypoint.x << ' ' << waypoint.y;
        }
    }

    /// One tick towards a place. False from half a minute of them on.
    bool step_to(double x, double y, std::uint8_t buttons = 0) {
        TickInput input =
            step_towards(x - number_of(state_.player.position.x), y - number_of(state_.player.position.y));
        input.buttons = buttons;
        step(level_, state_, input);
        return ++lone_steps_ < 30 * kTicksPerSecond;
    }

  private:
    TickInput step_towards(double dx, double dy) const {
        TickInput input;
        input.forward = 100;
        const auto wanted = static_cast<std::uint16_t>(std::lround(std::atan2(dy, dx) * 32768 / 3.14159265358979));
        input.yaw = static_cast<std::int16_t>(wanted - static_cast<std::uint16_t>(state_.player.yaw.bam));
        return input;
    }

    GameLevel level_;
    GameState state_;
    std::int64_t lone_steps_ = 0;
};

}  // namespace oblong::test
