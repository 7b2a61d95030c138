#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/costs/costs.h"
#include "engine/draw/drawing.h"
#include "engine/effects/palette_effects.h"
#include "engine/view/screen.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// "486 at 66 MHz: 6.1 frames/s", for a frame of so many cycles.
std::string describe_rate(Processor machine, std::int64_t cycles);

/// The text that F6 shows.
struct CostText {
    ColourTable background{};               ///< darkens the picture behind the text
    std::string frame;                      ///< time and rate of frames; empty: nothing is shown
    std::vector<PlanLine> passes, effects;  ///< the parts of the frame; effects without those that are passes
};

/// How the text is split into pages.
struct CostTable {
    std::int32_t height_px = 0;  ///< of each page; 0: nothing to show
    std::size_t lines = 0;       ///< in a column of a page
    std::int32_t pages = 1;
};

/// Measures the cost of the current view, as long as it exists.
class FrameCost {
  public:
    FrameCost(const Palette& palette, std::uint64_t now_us);

    /// Times one more rendering of the view that `renderer` has just drawn. Each half second it updates the text, for
    /// which it draws the same picture once more to count pixels.
    void note(const GameView& view, const Settings& settings, const Palette& palette, const PaletteEffects& effects,
              std::uint64_t now_us, GameRenderer& renderer);
    const CostText& text() const { return text_; }

  private:
    CostText text_;
    ViewTimes times_;
    std::uint64_t since_us_, frames_ = 0;
};

/// Messages to the player: the newest one is shown, for as long as it takes to read. All are kept in a list.
class Messages {
  public:
    /// Replaces the current message.
    void show(std::string text);
    /// Keeps a text that is shown elsewhere.
    void keep(const std::string& text);

    /// The lines to show from `now_us` on, at most `most_lines` of `columns` letters. Until then, the time of the lines
    /// returned last passes. A longer message is shown in parts.
    std::vector<std::string> lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines);

    /// Whether no message is shown.
    bool is_empty() const { return parts_.empty(); }

    /// All texts, the newest first, each text once; only the last 32 are kept.
    const std::vector<std::string>& all() const { return all_; }

  private:
    struct Part {
        std::string text;
        std::uint64_t left_us;
    };
    void pass_time(std::uint64_t now_us);
    void split_first(std::int32_t columns, std::size_t most_lines);

    std::vector<Part> parts_;  // of the newest message; the first is shown now or next
    std::vector<std::string> all_;
    bool is_up_ = false;
    std::uint64_t last_us_ = 0;
};

/// The text over a picture, except messages.
struct HudText {
    std::vector<std::string> captions;  ///< of sounds, at the bottom
    std::vector<std::string> notes;     ///< above the captions
    const CostText* cost = nullptr;     ///< above the notes; may be null
    std::int32_t cost_page = 1;
};

/// Rows [top, bottom) of a canvas.
struct RowRange {
    std::int32_t top = 0, bottom = 0;
    std::int32_t height() const { return bottom > top ? bottom - top : 0; }
};

/// Where the text over a picture is drawn. Its parts do not overlap; a part without room has no rows.
struct HudLayout {
    RowRange captions, cost;
    CostTable cost_table;
    std::vector<RowRange> notes;
    RowRange messages;  ///< all the rest
};

/// Lays text out in rows [0, bottom) of a canvas. A line for a message has priority, then captions, notes, cost.
HudLayout lay_out_hud(const HudText& text, bool has_messages, std::int32_t bottom, TextColours colours,
                      Framebuffer canvas);

/// Draws text and messages over a picture; returns the layout. `now_us`: of a clock that stops while the player cannot
/// read; `background` darkens the picture behind text.
HudLayout draw_hud(const HudText& text, Messages& messages, std::uint64_t now_us, std::int32_t bottom,
                   TextColours colours, const ColourTable& background, Framebuffer canvas);

}  // namespace oblong
