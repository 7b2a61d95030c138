#pragma once

#include <cstdint>

#include "engine/fixed/ratio.h"

namespace oblong {

/// A mode's size in pixels and the shape of the display that shows it. Pixel aspect comes from here and nowhere else:
/// make_projection() (geometry/projection.h) and layout() (platform/present_rect.h) are its two readers.
struct ScreenMode {
    std::int32_t width_px = 320, height_px = 200;
    Ratio display{4, 3};  ///< width to height of the whole picture as shown

    /// Width to height of one pixel as shown: 5:6 for 320x200 on 4:3 (Muratori: 1/a).
    constexpr Ratio pixel() const { return display * Ratio{height_px, width_px}; }
};

/// What the formats of the engine have head-room for (engine/fixed/README.md).
inline constexpr std::int32_t kLargestMode_px = 4096;

}  // namespace oblong
