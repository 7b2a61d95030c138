#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/simulation/demo.h"
#include "game/simulation/game_level.h"
#include "game/simulation/state.h"
#include "game/simulation/tick.h"

namespace oblong {

/// A place on the way of a simulated visitor.
struct Waypoint {
    std::int32_t x = 0, y = 0;               ///< world units
    std::optional<std::int32_t> least_feet;  ///< waits until the feet are as high: for a lift
    std::int32_t speed_100 = 50;             ///< percent of full speed on the way there
    std::int32_t wait_ticks = 0;             ///< the stay there
    std::optional<Angle> yaw;                ///< the view during the stay; none: unchanged
    std::int32_t pitch = 0;                  ///< on the way and during the stay, 65,536 to the circle, down positive
    bool jumps = false;                      ///< at the start of the way
    ViewDials view = kUsualView;             ///< during the stay, and from then on
    std::uint16_t work = 0;                  ///< likewise: TickInput::work, as a route draws nothing
    std::size_t line = 0;                    ///< of the file
};

/// Parses a CSV file. Its first line is "x,y,z,speed,wait,yaw,pitch,jump", perhaps with ",view"; the lines below are
/// whole numbers: world units, percent of full speed (default 50), tenths of a second (0), degrees, 1 for a jump; then
/// dials that are turned during the stay, as "accuracy=1991 work=900". All but x and y may be empty. Throws InputError
/// that names the line.
std::vector<Waypoint> parse_route(std::span<const std::uint8_t> bytes);

/// Makes the input of a visitor who walks from waypoint to waypoint (a teleporter on the way is one), turns smoothly at
/// a human's pace, and slows down at corners. Integers only, so that a route is the same walk on every machine.
class RouteWalker {
  public:
    explicit RouteWalker(std::span<const Waypoint> route) : route_(route) {}

    /// The input of the tick after a state. Requires !is_over().
    TickInput next(const GameState& state);

    bool is_over() const { return at_ == route_.size(); }
    /// True if the next waypoint was not reached within 40 seconds.
    bool is_stuck() const;
    const Waypoint& waypoint() const { return route_[at_]; }

  private:
    bool has_arrived(const Player& player);
    void turn(std::int32_t yaw_error, std::int32_t pitch_error, TickInput& input);

    std::span<const Waypoint> route_;
    std::size_t at_ = 0;
    std::int64_t ticks_ = 0, waited_ = 0;  // on the way to the waypoint, and at it
    bool is_there_ = false;
    std::optional<Position> last_;                // before the tick
    std::int32_t yaw_rate_ = 0, pitch_rate_ = 0;  // a tick
};

/// Walks a route from the start of a level to the end of the level or of the route. Throws InputError that names the
/// line of a waypoint that is not reached.
Demo walk_route(const GameLevel& level, std::span<const Waypoint> route);

}  // namespace oblong
