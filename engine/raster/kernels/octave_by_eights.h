#pragma once

#include <cstdint>

#include "engine/raster/octave_row.h"

namespace oblong {

// Draw the same bytes as OctaveRow's functions of these names, eight pixels at a time. Only for processors with
// Instructions::Avx512, and for at least eight pixels.

inline constexpr std::int32_t kFewestByEights = 8;

/// `count` pixels from the octave's first.
std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out);
void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);
void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);

}  // namespace oblong
