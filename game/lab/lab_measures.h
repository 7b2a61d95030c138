#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/accuracy/accuracy.h"
#include "engine/costs/costs.h"
#include "engine/measure/error_summary.h"
#include "game/lab/error_meter.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// A setting and the times of frames with it.
struct TimedSetting {
    Accuracy accuracy;
    ViewTimes times;
    std::optional<TimeSpread> frame_ns = {};  ///< of `times`; none before the first
};

/// The lab's measurements of the last views.
struct LabFigures {
    TimedSetting now, before;
    std::array<TimedSetting, kPresets.size()> presets;
    Events events{};                          ///< of a frame with the current setting
    std::optional<ErrorSummary> errors;       ///< pixels on the screen
    std::optional<std::int64_t> wrong_faces;  ///< pixels
    std::string problem;                      ///< why there are no errors
    /// Of light and mip levels: the distance of colours from exact ones at the same texels, RGB, 0 to 442; of the
    /// pixels that differ.
    std::optional<ErrorSummary> colour_errors;
    std::int32_t pixels = 0;  ///< of the picture
};

/// The distances of colours of two pictures, RGB, of the pixels that differ.
ErrorSummary colour_errors(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> exact,
                           const Palette& palette);

/// Measures the view in turns, one a frame: the time of one setting; costs; errors of places; wrong faces; errors
/// of colours.
class LabMeasures {
  public:
    explicit LabMeasures(FrameClock clock = steady_clock_ns);

    /// Takes the next turn. A time is of the second of two renderings, whose surfaces are lit already.
    void measure(const GameView& view, const Settings& now, const Accuracy& before, GameRenderer& renderer,
                 ErrorMeter& meter, const Palette& palette);
    const LabFigures& figures() const { return figures_; }

  private:
    void note_errors(const std::vector<TexelError>& errors, const std::string& problem);
    void follow(const Accuracy& now, const Accuracy& before);
    void time(TimedSetting& setting, const GameView& view, Settings settings, GameRenderer& renderer);
    void count(const GameView& view, const Settings& now, GameRenderer& renderer);
    void compare_colours(const GameView& view, Settings settings, GameRenderer& renderer, const Palette& palette);

    FrameClock clock_;
    LabFigures figures_;
    std::size_t turn_ = 0;
};

}  // namespace oblong
