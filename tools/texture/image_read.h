#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong {

/// Palette indices, rows top to bottom.
struct IndexedImage {
    std::int32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
};

/// A PNG as palette indices. An 8-bit indexed PNG with this very palette keeps its indices (two of them may have the
/// same colour, and one of the two glow); in any other each pixel takes the nearest colour. Throws InputError where the
/// bytes are no PNG.
IndexedImage read_png_as_indexed(std::span<const std::uint8_t> bytes, const Palette& palette);

}  // namespace oblong
