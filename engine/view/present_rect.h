#pragma once

#include <cstdint>
#include <string>

#include "engine/view/screen.h"

namespace oblong {

/// How a picture is scaled to the window.
enum class Scaling {
    SharpBilinear,  ///< nearest to the next whole multiple, then linear down: exact shape, edges a pixel wide
    Rows,           ///< whole rows, exact shape: only columns are blended
    Even,           ///< whole columns and rows: nothing is blended, the shape is off by `shape_error_permille`
    Nearest         ///< exact shape, nearest neighbour: some rows and columns are a pixel wider
};
inline constexpr int kScalingCount = 4;

/// "sharp", "rows", "even", "nearest".
const char* name_of(Scaling scaling);

/// Which shape the picture gets in the window.
enum class ShownAs {
    OnDisplay,     ///< the mode's display: 4:3 unless said otherwise
    SquarePixels,  ///< the window's pixels are the picture's: 320x200 is 8:5
    FillWindow     ///< the window's own shape: right where the monitor itself is the 4:3 display
};
inline constexpr int kShownAsCount = 3;

/// A size of window, in the pixels of the device. Anything, also 0.
struct WindowSize {
    std::int32_t width_px = 0, height_px = 0;
    bool operator==(const WindowSize&) const = default;
};

/// Where and how the picture is shown. Whole multiples come first (`upscale`), then one blend down to width x height.
struct PresentRect {
    std::int32_t x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    std::int32_t upscale_x = 1, upscale_y = 1;
    bool is_blended = false;                ///< the last step is linear; else nearest
    std::int32_t shape_error_permille = 0;  ///< pixels too wide (positive) or too narrow, against the shape asked for
    bool has_crt_look = false;              ///< scanlines, mask and glow of a tube, where the platform can

    bool operator==(const PresentRect&) const = default;
};

/// The rectangle of a picture of `mode` in a window, centred. Integers only; fits the window at every size. A window
/// without pixels gets an empty rectangle, any other at least one pixel. A window too small for a whole row or column
/// is scaled by SharpBilinear instead of Rows and Even.
PresentRect layout(WindowSize window, const ScreenMode& mode, ShownAs shown_as, Scaling scaling);

/// "4:5, -4.0 %" for whole multiples of `mode`, "x 4.50, y 5.40" for others.
std::string describe(const PresentRect& rect, const ScreenMode& mode);

}  // namespace oblong
