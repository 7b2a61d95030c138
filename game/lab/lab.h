#pragma once

#include <optional>

#include "engine/draw/text.h"
#include "game/lab/error_map.h"
#include "game/lab/lab_measures.h"
#include "game/lab/lab_options.h"
#include "game/lab/lab_panel.h"

namespace oblong {

/// The lab's drawing over the game's picture, and its measurements, with its own renderer. It exists only while a part
/// of it is on.
class Lab {
  public:
    /// `data` and `level` outlive it.
    Lab(const GameData& data, const GameLevel& level, const ScreenMode& mode, ColourScheme scheme,
        std::int32_t text_scale);

    /// Draws the parts that are on over the canvas, which shows `view` with shown_setting(). `settings`: the current
    /// ones. `is_short`: leaves room for another panel. Returns the row above which it ends.
    std::int32_t draw(const LabOptions& options, const GameView& view, const Settings& settings, std::uint64_t now_us,
                      bool is_short, Framebuffer canvas);

    /// Notes on what draw() drew, for KeyNames::in().
    std::vector<std::string> notes(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us) const;

  private:
    ErrorMeter& meter();
    void draw_errors(const GameView& view, const Settings& shown, Framebuffer canvas);
    void draw_exact_side(const LabOptions& options, const GameView& view, Settings settings, Framebuffer canvas);

    const GameData& data_;
    const GameLevel& level_;
    PanelColours colours_;
    GameRenderer renderer_;
    std::optional<ErrorMeter> meter_;  // made at the first use
    ErrorMap error_map_;
    LabMeasures measures_;
};

/// Replaces the right side of the canvas by that of another picture, with a line between them.
void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas);

}  // namespace oblong
