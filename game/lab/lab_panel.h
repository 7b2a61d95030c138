#pragma once

#include "engine/draw/drawing.h"
#include "engine/draw/text.h"
#include "engine/surface/palette.h"
#include "game/lab/lab_measures.h"
#include "game/lab/lab_options.h"

namespace oblong {

/// The colours of the panel, the scale of its letters, and the table that darkens the picture behind it.
struct PanelColours {
    TextColours bright, dim;
    std::uint8_t bar = 0, chosen = 0;
    ColourTable background{};
};
PanelColours panel_colours_of(const Palette& palette, std::int32_t scale);

/// Draws the lab's panel over the bottom of the canvas: the dials, times, errors and operations. Returns its top row.
/// `is_short`: only the chosen dial, times and errors, so that another panel fits. A canvas narrower than 320 pixels of
/// its letters gets one column and fewer lines.
std::int32_t draw_lab_panel(const LabOptions& options, const LabFigures& figures, const PanelColours& colours,
                            bool is_short, Framebuffer canvas);

/// A count in at most four characters: "999", "64k", "1.2M".
std::string short_count(std::int64_t count);

}  // namespace oblong
