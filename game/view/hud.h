#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/view/screen.h"
#include "game/view/frame_cost.h"
#include "game/view/messages.h"

namespace oblong {

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
