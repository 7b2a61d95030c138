#pragma once

#include <memory>
#include <optional>

#include "game/error_map.h"
#include "game/lab_measures.h"
#include "game/lab_options.h"
#include "game/lab_panel.h"

namespace oblong {

/// What the lab shows over the game's picture, and all that it computes for it, with a renderer of its own. It exists
/// only while something of it is on.
class Lab {
  public:
    /// `data` and `level` outlive it.
    Lab(const GameData& data, const GameLevel& level, const ScreenMode& mode, ColourScheme scheme);

    /// Draws what is on over the canvas, which shows `view` with shown_setting(). `settings`: the current ones. The row
    /// above which its text at the bottom ends.
    std::int32_t draw(const LabOptions& options, const GameView& view, const Settings& settings, std::uint64_t now_us,
                      Framebuffer canvas);

  private:
    ErrorMeter& meter();
    void draw_errors(const GameView& view, const Settings& shown, Framebuffer canvas);
    void draw_exact_side(const LabOptions& options, const GameView& view, Settings settings, Framebuffer canvas);
    std::int32_t draw_panel(const LabOptions& options, const GameView& view, const Settings& settings,
                            Framebuffer canvas);
    std::int32_t draw_captions(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us,
                               std::int32_t bottom, Framebuffer canvas) const;

    const GameData& data_;
    const GameLevel& level_;
    TextColours colours_;
    PanelColours panel_colours_;
    GameRenderer renderer_;
    std::optional<ErrorMeter> meter_;  // made when errors are first asked for
    ErrorMap error_map_;
    LabMeasures measures_;
};

}  // namespace oblong
