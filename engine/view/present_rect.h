#pragma once

#include <cstdint>
#include <string>

#include "engine/view/screen.h"

namespace oblong {

/// How a picture is scaled to the window.
enum class Scaling {
    SharpBilinear,  ///< nearest neighbour up to the next whole multiple, then linear down: exact shape, blurred edges
                    ///< one pixel wide
    Rows,           ///< whole rows, exact shape; only columns are blended
    Even,           ///< whole columns and rows; nothing is blended, the shape has `shape_error_permille`
    Nearest         ///< exact shape, nearest neighbour; some rows and columns are a pixel wider
};
inline constexpr int kScalingCount = 4;

/// "sharp", "rows", "even", "nearest".
const char* name_of(Scaling scaling);

/// The picture's shape in the window.
enum class ShownAs {
    OnDisplay,     ///< the shape of the mode's display, 4:3 by default
    SquarePixels,  ///< square pixels: 320x200 is 8:5
    FillWindow     ///< the window's shape: for monitors that are the 4:3 display
};
inline constexpr int kShownAsCount = 3;

/// A window's size in device pixels; any number, also 0.
struct WindowSize {
    std::int32_t width_px = 0, height_px = 0;
    bool operator==(const WindowSize&) const = default;
};

/// Where and how the picture is shown: first scaled up by whole multiples (`upscale`), then down to width x height.
struct PresentRect {
    std::int32_t x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    std::int32_t upscale_x = 1, upscale_y = 1;
    bool is_blended = false;                ///< the last step is linear, else nearest
    std::int32_t shape_error_permille = 0;  ///< pixels are too wide (positive) or too narrow
    bool has_crt_look = false;              ///< scanlines, mask and glow of a tube, if the platform supports it

    bool operator==(const PresentRect&) const = default;
};

/// The centred rectangle of a picture of `mode` in a window; always inside the window. It is empty for a window without
/// pixels, otherwise at least one pixel. If the window is smaller than the mode, Rows and Even become SharpBilinear.
PresentRect layout(WindowSize window, const ScreenMode& mode, ShownAs shown_as, Scaling scaling);

/// "4:5, -4.0 %" for whole multiples of `mode`, "x 4.50, y 5.40" for others.
std::string describe(const PresentRect& rect, const ScreenMode& mode);

}  // namespace oblong
