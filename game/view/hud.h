#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/view/screen.h"
#include "game/view/frame_cost.h"
#include "game/view/messages.h"

namespace oblong {

/// What is written over a picture beside messages.
struct HudText {
    std::vector<std::string> captions;  ///< of sounds: at the bottom
    std::vector<std::string> notes;     ///< likewise, above them
    const CostText* cost = nullptr;     ///< likewise, above those; may be null
    std::int32_t cost_page = 1;
};

/// RowRange [top, bottom) of a canvas.
struct RowRange {
    std::int32_t top = 0, bottom = 0;
    std::int32_t height() const { return bottom > top ? bottom - top : 0; }
};

/// Where the text over a picture goes: no two of its parts share a row. What has no room has no rows.
struct HudLayout {
    RowRange captions, cost;
    CostTable cost_table;
    std::vector<RowRange> notes;
    RowRange messages;  ///< all that is left for them
};

/// Lays text out in rows [0, bottom) of a canvas. Room for a message's line comes first, then captions, notes and cost.
HudLayout lay_out_hud(const HudText& text, bool has_messages, std::int32_t bottom, TextColours colours,
                      Framebuffer canvas);

/// Draws text and messages over a picture, and says where. `now_us` may be any clock that stands still while the player
/// can't read; `background`: what the picture becomes behind text.
HudLayout draw_hud(const HudText& text, Messages& messages, std::uint64_t now_us, std::int32_t bottom,
                   TextColours colours, const ColourTable& background, Framebuffer canvas);

}  // namespace oblong
