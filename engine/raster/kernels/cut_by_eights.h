#pragma once

#include <cstdint>
#include <span>

#include "engine/raster/texture_blocks.h"

namespace oblong {

// Blocks of Texturing::Bounded by eights: the texels at eight of their ends are found at a time. Only for processors
// that have Instructions::Avx512. Eight blocks are written at a time, too: up to seven beyond those that are appended.

/// Whether the functions below serve: nothing has to be clamped before it is multiplied, and no block is more than
/// 1,024 texels long.
bool can_cut_by_eights(const BlockCutting& cutting);

/// Appends the blocks of spans that are one block each. Returns the list's new end.
TexelBlock* cut_whole_spans_by_eights(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                      TexelBlock* out);

/// Appends the blocks of spans in the same columns as the span `above`, whose blocks these are, of a surface that
/// RowRepeater serves: they differ in v alone. Returns the list's new end.
TexelBlock* repeat_rows_by_eights(const Span& above, std::span<const TexelBlock> blocks, std::span<const Span> spans,
                                  std::int32_t pitch, const BlockCutting& cutting, TexelBlock* out);

}  // namespace oblong
