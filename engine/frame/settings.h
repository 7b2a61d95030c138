#pragma once

#include <cstdint>

namespace oblong {

/// How texture coordinates are found along a span.
enum class Texturing {
    Affine,   ///< a division at each end of the span
    Every16,  ///< a division every 16 pixels (Quake's)
    Bounded,  ///< the longest affine blocks whose error on screen stays under Accuracy::texture_error_px_256
    Exact     ///< a division a pixel
};

/// The dials. Each is an approximation whose error and cost are measured (tools/accuracy).
struct Accuracy {
    Texturing texturing = Texturing::Bounded;
    std::int32_t texture_error_px_256 = 96;  ///< Bounded: the largest error on screen, 1/256 pixel; 1 to 4,096
    std::int32_t subpixel_bits = 8;          ///< fraction bits of screen vertices: 0 (whole pixels) to 8
    bool operator==(const Accuracy&) const = default;
};

/// The named tiers (--accuracy): what could be afforded in that year, and two that no year could.
enum class Tier { Year1991, Year1994, Year1996, Bounded, Exact };
Accuracy accuracy_of(Tier tier);
/// "1991", "1994", "1996", "bounded", "exact".
const char* name_of(Tier tier);

/// What the player or the developer sets; together with level, camera and time it determines a frame.
struct Settings {
    Accuracy accuracy;
    bool correct_aspect = true;  ///< false: the projection takes pixels for square (F2 in the game)
};

}  // namespace oblong
