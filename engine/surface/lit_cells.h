#pragma once

#include <cstdint>

#include "engine/surface/colormap.h"

namespace oblong {

/// A row of cells of a lit surface (build_lit_surface), at least one; each is between four light samples.
struct LitCells {
    const std::int32_t* upper_16;  ///< `columns` shades above the cells, followed by those below
    std::int32_t columns;
    const std::uint8_t* texels;  ///< the texture's first row for these cells
    std::int32_t first_u, texture_width;
    std::int32_t stride;  ///< of `out`
    std::uint8_t* out;
};

/// Lights cells of mip level 0 or 1 with interpolated shades, not dithered, eight texels at a time. Returns false and
/// writes nothing if the processor does not support it.
bool light_cells_by_eights(const LitCells& cells, int mip, const Colormap& colormap);

}  // namespace oblong
