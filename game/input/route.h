#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "game/simulation/demo.h"
#include "game/simulation/game_level.h"
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

/// Walks a route from the start of a level to the end of the level or of the route. Throws InputError that names the
/// line of a waypoint that is not reached.
Demo walk_route(const GameLevel& level, std::span<const Waypoint> route);

}  // namespace oblong
