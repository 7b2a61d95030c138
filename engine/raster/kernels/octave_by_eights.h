#pragma once

#include <cstdint>

#include "engine/raster/octave_row.h"

namespace oblong {

// Pixels of an octave by eights: the same bytes as OctaveRow's functions of these names draw. Only for processors that
// have Instructions::Avx512, and for eight pixels or more.

inline constexpr std::int32_t kFewestByEights = 8;

/// From the octave's first pixel on.
std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out);
void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);
void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);

}  // namespace oblong
