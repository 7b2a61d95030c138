#pragma once

#include <cstdint>
#include <span>

#include "engine/raster/octave_row.h"
#include "engine/raster/scan.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

// Cuts blocks of Texturing::Bounded with the texels of eight ends at a time. Only for processors with
// Instructions::Avx512. Writes eight blocks at a time: up to seven beyond the list's new end.

/// Whether the functions below can be used: nothing has to be clamped before multiplication, and no block is longer
/// than 1,024 texels.
bool can_cut_by_eights(const BlockCutting& cutting);

/// Appends the blocks of spans that are one block each. Returns the list's new end.
TexelBlock* cut_whole_spans_by_eights(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                      TexelBlock* out);

/// Appends the blocks of spans in the same columns as the span `above` with its `blocks`: they differ in v only. For
/// surfaces that RowRepeater serves. Returns the list's new end.
TexelBlock* repeat_rows_by_eights(const Span& above, std::span<const TexelBlock> blocks, std::span<const Span> spans,
                                  std::int32_t pitch, const BlockCutting& cutting, TexelBlock* out);

// Draw the same bytes as OctaveRow's functions of these names, those of surfaces that warp with WarpedColours, eight
// pixels at a time. Only for processors with Instructions::Avx512, and for at least eight pixels.

inline constexpr std::int32_t kFewestByEights = 8;

/// `count` pixels from the octave's first.
std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out);
std::int32_t draw_warped_by_eights(const OctaveRow& row, const EffectTexels& texels, std::int32_t count,
                                   std::uint8_t* out);
void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);
void draw_warped_at_depths_by_eights(const OctaveRow& row, const EffectTexels& texels, const ColumnTexel* columns,
                                     std::int32_t count, std::uint8_t* out);
void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out);

/// Sets the columns of a polygon on the screen whose outline is_monotone, eight rows at a time: those of ScreenWalker.
/// Only for processors with Instructions::Avx512.
void scan_edges_by_eights(std::span<const ScreenVertex> vertices, ScanlineExtents& rows);

}  // namespace oblong
