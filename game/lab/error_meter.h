#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/measure/error_summary.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// Measures how far the texels of a game's frame are from their exact places. An interface, since the reference
/// computes in doubles and 128-bit integers, which not every system has.
class ErrorMeter {
  public:
    virtual ~ErrorMeter() = default;

    /// The error of each pixel; empty if there is a problem.
    virtual std::vector<TexelError> measure(const GameView& view, const Settings& settings, GameRenderer& renderer) = 0;
    /// The pixels of a wrong face; none if there is a problem, or the view is not the one of the last call: what it
    /// should show takes too long to find while the player, or a model in sight, moves.
    virtual std::optional<std::int64_t> count_wrong_faces(const GameView& view, const Settings& settings,
                                                          GameRenderer& renderer) = 0;
    /// Why nothing can be measured in a view; empty if it can.
    virtual std::string problem_of(const GameView& view) const = 0;
};

/// Makes the meter of a level, whose file may be read for it. `level` outlives the meter.
using OpenErrorMeter = std::unique_ptr<ErrorMeter> (*)(const std::string& level_file, const GameLevel& level);

/// One that measures by the reference, which reads the level's file a second time.
std::unique_ptr<ErrorMeter> open_reference_meter(const std::string& level_file, const GameLevel& level);
/// The meter of `open`; if that is null, one whose problem is that it measures nothing.
std::unique_ptr<ErrorMeter> open_meter_of(OpenErrorMeter open, const std::string& level_file, const GameLevel& level);

}  // namespace oblong
