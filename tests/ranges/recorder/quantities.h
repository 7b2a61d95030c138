#pragma once

#include <array>
#include <bit>

#include "engine/base/range_probe.h"

namespace oblong {

/// What the table says of a quantity. `bits`: how many bits of size it may have, sign not counted.
struct QuantityInfo {
    const char *name, *format, *place;
    int bits;
};

/// In the order of Quantity.
inline constexpr std::array<QuantityInfo, static_cast<std::size_t>(Quantity::Count)> kQuantities = {{
    {"view position", "48.16", "math/basis.h", 63},
    {"axis . (p - eye)", "22.42", "math/basis.h", 63},
    {"plane distance", "22.42", "level/side.cpp", 63},
    {"texel of the eye", "48.16", "scene/face_gradients.cpp", 63},
    {"texture axis . eye", "29.35", "scene/face_gradients.cpp", 63},
    {"clip distance", "slope x 48.16", "geometry/frustum.h", 63},
    {"clip distance, whole edge", "slope x 48.16", "geometry/clip.cpp", 63},
    {"cull plane's normal", "19.45", "geometry/frustum.cpp", 63},
    {"box's cull distance", "32.32", "visibility/front_to_back.cpp", 63},
    {"projection numerator", "32.32", "geometry/projection.h", 63},
    {"screen position before clamping", "56.8", "geometry/project.cpp", 63},
    {"edge numerator", "48.16", "raster/scan.cpp", 63},
    {"edge rest", "48.16", "raster/scan.cpp", 63},
    {"normal in view axes", "4.60", "geometry/texture_gradients.cpp", 63},
    {"texture axis in view axes", "11.53", "geometry/texture_gradients.cpp", 63},
    {"slope of 1/z", "20.44", "geometry/texture_gradients.cpp", 63},
    {"slope of u/z, v/z", "34.30", "geometry/texture_gradients.cpp", 63},
    {"1/z at a block's end", "20.44", "raster/texture_blocks.cpp", 63},
    {"u/z, v/z at a block's end", "34.30", "raster/texture_blocks.cpp", 63},
    {"u/z, normalised", "0.60", "raster/texture_blocks.cpp", 63},
    {"u/z x reciprocal", "0.60", "raster/texture_blocks.cpp", 63},
    {"block thresholds", "20.44", "raster/block_rule.cpp", 63},
    {"mip comparison, before doubling", "48.16", "scene/face_surface.cpp", 62},
}};

/// How many bits the size of a value takes, its sign not counted.
constexpr int bits_of(std::int64_t value) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)));
}

static_assert(bits_of(0) == 0 && bits_of(1) == 1 && bits_of(255) == 8 && bits_of(256) == 9);
static_assert(bits_of(-1) == 0 && bits_of(-256) == 8 && bits_of(-257) == 9);

}  // namespace oblong
