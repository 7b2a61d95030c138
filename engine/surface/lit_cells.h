#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/surface/colormap.h"

namespace oblong {

/// A row of the cells of a lit surface (build_lit_surface), of at least one: each lies between four light samples.
struct LitCells {
    const std::int32_t* upper_16;  ///< the shades above the cells, `columns` of them; below them: those behind these
    std::int32_t columns;
    const std::uint8_t* texels;  ///< of the texture, in the first row of texels
    std::int32_t first_u, texture_width;
    std::int32_t stride;  ///< of `out`
    std::uint8_t* out;
};

/// Lights cells of mip level 0 or 1 by interpolated shades that are not dithered, eight texels at a time. False: this
/// processor can't, and nothing is written.
bool light_cells_by_eights(const LitCells& cells, int mip, const Colormap& colormap);

}  // namespace oblong
