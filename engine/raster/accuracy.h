#pragma once

#include <cstdint>

namespace oblong {

/// How texture coordinates are found along a span.
enum class Texturing {
    Affine,   ///< a division at the first and the last pixel of the span
    Every16,  ///< a division every 16 pixels (Quake's)
    Bounded,  ///< the longest affine blocks whose error on screen stays under Accuracy::texture_error_px_256
    Exact     ///< a division a pixel
};

/// The dials. Each is an approximation whose error and cost can be measured.
struct Accuracy {
    Texturing texturing = Texturing::Bounded;
    std::int32_t texture_error_px_256 = 96;  ///< Bounded: the largest error on screen, 1/256 pixel; 1 to 4,096
    std::int32_t subpixel_bits = 8;          ///< fraction bits of screen vertices: 0 (whole pixels) to 8
    bool operator==(const Accuracy&) const = default;
};

}  // namespace oblong
