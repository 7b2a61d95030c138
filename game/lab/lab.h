#pragma once

#include <array>
#include <memory>
#include <span>

#include "engine/draw/drawing.h"
#include "engine/measure/error_summary.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"
#include "game/lab/lab_measures.h"
#include "game/lab/lab_options.h"
#include "game/view/sign_colours.h"

namespace oblong {

/// The colours of the panel, the scale of its letters, and the table that darkens the picture behind it.
struct PanelColours {
    TextColours bright, dim;
    std::uint8_t bar = 0, chosen = 0;
    ColourTable background{};
};
PanelColours panel_colours_of(const Palette& palette, std::int32_t scale);

/// Draws the lab's panel over the bottom of the canvas: the dials, times, errors and costs. Returns its top row.
/// `is_short`: only the chosen dial, times and errors, so that another panel fits. A canvas narrower than 320 pixels of
/// its letters gets one column and fewer lines.
std::int32_t draw_lab_panel(const LabOptions& options, const LabFigures& figures, const PanelColours& colours,
                            bool is_short, Framebuffer canvas);

/// A count in at most four characters: "999", "64k", "1.2M".
std::string short_count(std::int64_t count);
/// "0.37", "12.5", "240".
std::string three_digits(double value);

/// The map of the error: each pixel's colour shows how far its texel is from its exact place.
class ErrorMap {
  public:
    /// Errors below the first are dark grey; from each of these on, in 1/256 pixel, another colour begins.
    static constexpr std::array kSteps_256{32, 64, 128, 256, 512, 1024};  // 1/8 to 4 pixels
    static constexpr std::size_t kBands = kSteps_256.size() + 1;
    static_assert(kBands == kErrorBands);

    ErrorMap(const Palette& palette, ColourScheme scheme);

    /// Colours each pixel of a picture by its error, and keeps its brightness visible. `errors`: one for each pixel.
    void draw(std::span<const TexelError> errors, Framebuffer canvas) const;
    /// Draws the legend, with the smallest error of each colour, above the row `bottom`. Returns its top row.
    std::int32_t draw_legend(std::int32_t bottom, TextColours colours, Framebuffer canvas) const;

    /// The band of an error in pixels: 0 below the first step, and without a measurement.
    static std::size_t band_of(float pixels);

  private:
    std::array<ColourTable, kBands> tints_{};  // by band and the colour of the picture
    std::array<std::uint8_t, kBands> swatches_{};
};

/// The lab's drawing over the game's picture, and its measurements, with its own renderer. It exists only while a part
/// of it is on.
class Lab {
  public:
    /// `data` and `level` outlive it.
    Lab(const GameData& data, const GameLevel& level, const ScreenMode& mode, ColourScheme scheme,
        std::int32_t text_scale, OpenErrorMeter open_meter);

    /// Draws the map of errors and the exact side, where they are on, over the canvas, which shows `view` with
    /// shown_setting(). `settings`: the current ones.
    void draw_pictures(const LabOptions& options, const GameView& view, const Settings& settings, std::uint64_t now_us,
                       Framebuffer canvas);
    /// Draws the panel and the map's legend. `is_short`: leaves room for another panel. Returns the row above which it
    /// ends.
    std::int32_t draw_panel(const LabOptions& options, const GameView& view, const Settings& settings, bool is_short,
                            Framebuffer canvas);

    /// Notes on what is drawn, for KeyNames::in().
    std::vector<std::string> notes(const LabOptions& options, const GameView& view, const Accuracy& accuracy,
                                   std::uint64_t now_us);

  private:
    ErrorMeter& meter();

    const GameData& data_;
    const GameLevel& level_;
    PanelColours colours_;
    GameRenderer renderer_;
    const OpenErrorMeter open_meter_;
    std::unique_ptr<ErrorMeter> meter_;  // made at the first use
    ErrorMap error_map_;
    LabMeasures measures_;
};

/// Replaces the right side of the canvas by that of another picture, with a line between them.
void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas);

}  // namespace oblong
