#pragma once

#include "engine/fixed/fixed.h"

namespace oblong {

/// A vertex on the screen, pixels, 24.8: written by projection, read by the scan converter. Pixel centres lie at +0.5.
struct ScreenVertex {
    Screen x, y;
    constexpr bool operator==(const ScreenVertex&) const = default;
};

}  // namespace oblong
