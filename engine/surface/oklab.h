#pragma once

#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// A colour in OKLab (Ottosson 2020), with 14 fraction bits: lightness 0 to 1; green to red and blue to yellow, each
/// within +-0.32.
struct Oklab {
    std::int32_t lightness_14 = 0, green_red_14 = 0, blue_yellow_14 = 0;
};

/// A colour in sRGB, channels 0 to 255 with 8 fraction bits: whole steps would lose the hue of dark shades.
struct FineRgb {
    std::int32_t red_8 = 0, green_8 = 0, blue_8 = 0;
};

/// Within 2^-12 of the exact values.
Oklab oklab_of(const FineRgb& colour);

}  // namespace oblong
