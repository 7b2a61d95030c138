#pragma once

#include <algorithm>

#include "engine/base/table.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"
#include "engine/raster/span_cutter.h"
#include "engine/raster/texture_blocks.h"

// Cutting the spans of one surface into blocks, compiled for each texturing, reciprocal and range: texture_blocks.cpp
// chooses.

namespace oblong {

template <class Cutter>
inline void cut_every(Cutter& cutter, int log2) {
    while (cutter.remaining() > 1 << log2) cutter.cut_power(log2);
    cutter.cut_rest();
}

/// Cuts blocks as long as the bound allows at their first pixel; the search starts at the last block's size.
template <class Cutter>
inline void cut_bounded(Cutter& cutter, const BlockThresholds& thresholds, std::ptrdiff_t& log2) {
    const auto& least = thresholds.least_inverse_z;
    while (true) {
        while (cutter.inverse_z() >= item(least, log2 + 1)) ++log2;
        while (cutter.inverse_z() < item(least, log2)) --log2;
        if (cutter.remaining() <= 1 << log2) return cutter.cut_rest();
        cutter.cut_power(static_cast<int>(log2));
    }
}

/// Tries a block twice as long as the last, then halves it until it is within the bound.
template <class Cutter>
inline void cut_bounded_texels(Cutter& cutter, std::int32_t bound_256) {
    int log2 = 3;
    while (cutter.remaining() > 1) {
        while (!cutter.try_block(log2, bound_256)) --log2;
        log2 = std::min(log2 + 1, kBlockSizes - 1);
    }
    if (cutter.remaining() == 1) cutter.cut_rest();
}

template <Texturing How, class Cutter>
inline void cut_span(Cutter& cutter, const BlockCutting& cutting, std::ptrdiff_t& log2) {
    if constexpr (How == Texturing::Affine) cutter.cut_rest();
    if constexpr (How == Texturing::Every32) cut_every(cutter, 5);
    if constexpr (How == Texturing::Every16) cut_every(cutter, 4);
    if constexpr (How == Texturing::Every8) cut_every(cutter, 3);
    if constexpr (How == Texturing::Bounded) cut_bounded(cutter, cutting.thresholds, log2);
    if constexpr (How == Texturing::BoundedTexels) cut_bounded_texels(cutter, cutting.texel_bound_256);
    if constexpr (How == Texturing::Exact) cut_every(cutter, 0);
}

/// Returns the remaining spans.
template <Texturing How, PerspectiveRange Range, class Reciprocal>
inline std::span<const Span> cut_spans(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                       Reciprocal reciprocal, BlockList& blocks) {
    SpanCutter<Reciprocal, Range> cutter(cutting, reciprocal, blocks.end());
    const TexelBlock* const last_start = blocks.last_start();
    std::ptrdiff_t log2 = 0;
    const Span* span = spans.data();
    const Span* const end = span + spans.size();
    for (; span != end && cutter.end() <= last_start; ++span) {
        cutter.start(*span, pitch);
        cut_span<How>(cutter, cutting, log2);
    }
    blocks.set_end(cutter.end());
    if constexpr (How == Texturing::BoundedTexels) blocks.add_divisions(cutter.tries());
    return {span, end};
}

/// The leading spans with the same columns as `columns`, as many as have room for `blocks` blocks each.
inline std::span<const Span> spans_in(const Span& columns, std::span<const Span> spans, std::ptrdiff_t blocks,
                                      std::ptrdiff_t room) {
    std::size_t count = 0;
    for (; room >= 0 && count < spans.size(); room -= blocks, ++count)
        if (spans[count].first != columns.first || spans[count].end != columns.end) break;
    return spans.first(count);
}

/// cut_spans() for RowRepeater's surfaces.
template <Texturing How, PerspectiveRange Range, class Reciprocal>
inline std::span<const Span> cut_repeating_rows(std::span<const Span> spans, std::int32_t pitch,
                                                const BlockCutting& cutting, Reciprocal reciprocal, BlockList& blocks) {
    SpanCutter<Reciprocal, Range> cutter(cutting, reciprocal, blocks.end());
    const TexelBlock* const last_start = blocks.last_start();
    std::ptrdiff_t log2 = 0;
    std::int64_t divisions_saved = 0;
    while (!spans.empty() && cutter.end() <= last_start) {
        const Span& above = spans.front();
        const TexelBlock* const first = cutter.end();
        cutter.start(above, pitch);
        cut_span<How>(cutter, cutting, log2);
        spans = spans.subspan(1);
        const std::span<const TexelBlock> row(first, cutter.end());
        if (row.size() > RowRepeater<Reciprocal>::kMostBlocks || cutter.end() > last_start) continue;
        const std::span<const Span> below = spans_in(above, spans, std::ssize(row), last_start - cutter.end());
        if (below.empty()) continue;
        const RowRepeater<Reciprocal> repeater(above, row, cutting, reciprocal);
        TexelBlock* out = cutter.end();
        for (const Span& span : below) out = repeater.repeat(span.y, pitch, out);
        cutter.set_end(out);
        divisions_saved += std::ssize(below) * (std::ssize(row) + (row.back().count > 1)) - (std::ssize(row) + 1);
        spans = spans.subspan(below.size());
    }
    blocks.set_end(cutter.end());
    blocks.add_divisions(-divisions_saved);
    return spans;
}

/// For spans that are one block each.
template <class Ends>
inline std::span<const Span> cut_whole_spans(std::span<const Span> spans, std::int32_t pitch, Ends ends,
                                             BlockList& blocks) {
    const Span* span = spans.data();
    const Span* const end = span + spans.size();
    TexelBlock* out = blocks.end();
    for (const TexelBlock* const last_start = blocks.last_start(); span != end && out <= last_start; ++span) {
        const std::int32_t steps = span->end - span->first - 1;
        const TexelPosition from = ends.first(*span);
        TexelStep step;
        if (steps != 0) step = steps_by_division(from, ends.last(*span), steps);
        *out++ = {static_cast<std::uint32_t>(span->y * pitch + span->first),
                  steps + 1,
                  from.u_16,
                  from.v_16,
                  step.u_16,
                  step.v_16};
    }
    blocks.set_end(out);
    return {span, end};
}

/// cut_in_range() of a range that fits.
template <Texturing How, PerspectiveRange Range, class Reciprocal>
inline std::span<const Span> cut_fitting(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                         Reciprocal reciprocal, BlockList& blocks) {
    constexpr bool kIsBounded = How == Texturing::Bounded, kIsAffine = How == Texturing::Affine;
    constexpr bool kMayRepeat = How != Texturing::BoundedTexels && How != Texturing::Exact;
    const bool repeats_rows = kMayRepeat && RowRepeater<Reciprocal>::serves(cutting.gradients);
    if (kIsAffine || (kIsBounded && cutting.takes_whole_spans)) {
        if (repeats_rows)
            return cut_whole_spans(spans, pitch, RepeatedSpanEnds<Reciprocal, Range>(cutting, reciprocal), blocks);
        return cut_whole_spans(spans, pitch, SpanEnds<Reciprocal, Range>(cutting, reciprocal), blocks);
    }
    if constexpr (kMayRepeat && !kIsAffine)
        if (repeats_rows) return cut_repeating_rows<How, Range>(spans, pitch, cutting, reciprocal, blocks);
    return cut_spans<How, Range>(spans, pitch, cutting, reciprocal, blocks);
}

/// Whether all steps have 32 bits; only near walls seen from the side have longer ones.
inline bool has_short_steps(const TextureGradients& gradients) {
    const auto is_short = [](auto step) { return static_cast<std::int32_t>(step.raw) == step.raw; };
    const auto& [inverse_z, u_over_z, v_over_z] = gradients;
    return is_short(inverse_z.per_column) && is_short(inverse_z.per_row) && is_short(u_over_z.per_column) &&
           is_short(u_over_z.per_row) && is_short(v_over_z.per_column) && is_short(v_over_z.per_row);
}

template <Texturing How, class Reciprocal>
inline std::span<const Span> cut_in_range(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                          Reciprocal reciprocal, BlockList& blocks) {
    using enum PerspectiveRange;
    if (!cutting.fits_range) return cut_spans<How, MayOverflow>(spans, pitch, cutting, reciprocal, blocks);
    if constexpr (native::kHasShortRegisters)
        if (has_short_steps(cutting.gradients))
            return cut_fitting<How, FitsWithShortSteps>(spans, pitch, cutting, reciprocal, blocks);
    return cut_fitting<How, Fits>(spans, pitch, cutting, reciprocal, blocks);
}

}  // namespace oblong
