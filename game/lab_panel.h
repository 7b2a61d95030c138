#pragma once

#include "engine/surface/palette.h"
#include "game/lab_measures.h"
#include "game/lab_options.h"
#include "tools/common/drawing.h"
#include "tools/common/text.h"

namespace oblong {

/// The colours of the panel, and what the picture becomes behind it.
struct PanelColours {
    TextColours bright, dim;
    std::uint8_t bar = 0, chosen = 0;
    ColourTable background{};
};
PanelColours panel_colours_of(const Palette& palette);

/// How many rows of a canvas the panel takes at its bottom; fewer in a canvas that is not as high.
std::int32_t lab_panel_rows(Framebuffer canvas);

/// Draws the lab's panel over the bottom of the canvas: the dials, times, operations and errors. It is made for a width
/// of 320 pixels; what does not fit is cut.
void draw_lab_panel(const LabOptions& options, const LabFigures& figures, const PanelColours& colours,
                    Framebuffer canvas);

/// A count in at most four characters: "999", "64k", "1.2M".
std::string short_count(std::int64_t count);

}  // namespace oblong
