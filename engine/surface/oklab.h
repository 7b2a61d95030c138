#pragma once

#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// A colour as it is perceived (Ottosson 2020, OKLab), with 14 fraction bits: lightness 0 to 1; green to red and blue
/// to yellow, each within +-0.32.
struct Oklab {
    std::int32_t lightness_14 = 0, green_red_14 = 0, blue_yellow_14 = 0;
};

/// A colour in sRGB whose channels, 0 to 255, have 8 fraction bits: a dark shade of a colour has no room for its hue in
/// whole steps.
struct FineRgb {
    std::int32_t red_8 = 0, green_8 = 0, blue_8 = 0;
};

/// Within 2^-12 of the exact numbers.
Oklab oklab_of(const FineRgb& colour);

}  // namespace oblong
