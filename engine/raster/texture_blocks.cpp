#include "engine/raster/texture_blocks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/table.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"
#include "engine/raster/span_cutter.h"

#if defined(__x86_64__)
#define OBLONG_TARGET_BMI2 [[gnu::target("bmi2,lzcnt")]]
#else
#define OBLONG_TARGET_BMI2
#endif

namespace oblong {

namespace {

template <class Cutter>
[[gnu::always_inline]] inline void cut_every(Cutter& cutter, int log2) {
    while (cutter.remaining() > 1 << log2) cutter.cut_power(log2);
    cutter.cut_rest();
}

/// Cuts blocks as long as the bound allows at their first pixel; the search starts at the last block's size.
template <class Cutter>
[[gnu::always_inline]] inline void cut_bounded(Cutter& cutter, const BlockThresholds& thresholds,
                                               std::ptrdiff_t& log2) {
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
[[gnu::always_inline]] inline void cut_bounded_texels(Cutter& cutter, std::int32_t bound_256) {
    int log2 = 3;
    while (cutter.remaining() > 1) {
        while (!cutter.try_block(log2, bound_256)) --log2;
        log2 = std::min(log2 + 1, kBlockSizes - 1);
    }
    if (cutter.remaining() == 1) cutter.cut_rest();
}

template <Texturing How, class Cutter>
[[gnu::always_inline]] inline void cut_span(Cutter& cutter, const BlockCutting& cutting, std::ptrdiff_t& log2) {
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
[[gnu::always_inline]] inline std::span<const Span> cut_spans(std::span<const Span> spans, std::int32_t pitch,
                                                              const BlockCutting& cutting, Reciprocal reciprocal,
                                                              BlockList& blocks) {
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
[[gnu::always_inline]] inline std::span<const Span> spans_in(const Span& columns, std::span<const Span> spans,
                                                             std::ptrdiff_t blocks, std::ptrdiff_t room) {
    std::size_t count = 0;
    for (; room >= 0 && count < spans.size(); room -= blocks, ++count)
        if (spans[count].first != columns.first || spans[count].end != columns.end) break;
    return spans.first(count);
}

/// cut_spans() for RowRepeater's surfaces.
template <PerspectiveRange Range, class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_repeating_rows(std::span<const Span> spans, std::int32_t pitch,
                                                                       const BlockCutting& cutting,
                                                                       Reciprocal reciprocal, BlockList& blocks) {
    SpanCutter<Reciprocal, Range> cutter(cutting, reciprocal, blocks.end());
    const TexelBlock* const last_start = blocks.last_start();
    std::ptrdiff_t log2 = 0;
    std::int64_t divisions_saved = 0;
    while (!spans.empty() && cutter.end() <= last_start) {
        const Span& above = spans.front();
        const TexelBlock* const first = cutter.end();
        cutter.start(above, pitch);
        cut_bounded(cutter, cutting.thresholds, log2);
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
[[gnu::always_inline]] inline std::span<const Span> cut_whole_spans(std::span<const Span> spans, std::int32_t pitch,
                                                                    Ends ends, BlockList& blocks) {
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
[[gnu::always_inline]] inline std::span<const Span> cut_fitting(std::span<const Span> spans, std::int32_t pitch,
                                                                const BlockCutting& cutting, Reciprocal reciprocal,
                                                                BlockList& blocks) {
    constexpr bool kIsBounded = How == Texturing::Bounded, kIsAffine = How == Texturing::Affine;
    const bool repeats_rows = (kIsBounded || kIsAffine) && RowRepeater<Reciprocal>::serves(cutting.gradients);
    if (kIsAffine || (kIsBounded && cutting.takes_whole_spans)) {
        if (repeats_rows)
            return cut_whole_spans(spans, pitch, RepeatedSpanEnds<Reciprocal, Range>(cutting, reciprocal), blocks);
        return cut_whole_spans(spans, pitch, SpanEnds<Reciprocal, Range>(cutting, reciprocal), blocks);
    }
    if (repeats_rows) return cut_repeating_rows<Range>(spans, pitch, cutting, reciprocal, blocks);
    return cut_spans<How, Range>(spans, pitch, cutting, reciprocal, blocks);
}

#if defined(__i386__)
/// Whether all steps have 32 bits; only near walls seen from the side have longer ones.
bool has_short_steps(const TextureGradients& gradients) {
    const auto is_short = [](auto step) { return static_cast<std::int32_t>(step.raw) == step.raw; };
    const auto& [inverse_z, u_over_z, v_over_z] = gradients;
    return is_short(inverse_z.per_column) && is_short(inverse_z.per_row) && is_short(u_over_z.per_column) &&
           is_short(u_over_z.per_row) && is_short(v_over_z.per_column) && is_short(v_over_z.per_row);
}
#endif

template <Texturing How, class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_in_range(std::span<const Span> spans, std::int32_t pitch,
                                                                 const BlockCutting& cutting, Reciprocal reciprocal,
                                                                 BlockList& blocks) {
    using enum PerspectiveRange;
    if (!cutting.fits_range) return cut_spans<How, MayOverflow>(spans, pitch, cutting, reciprocal, blocks);
#if defined(__i386__)
    if (has_short_steps(cutting.gradients))
        return cut_fitting<How, FitsWithShortSteps>(spans, pitch, cutting, reciprocal, blocks);
#endif
    return cut_fitting<How, Fits>(spans, pitch, cutting, reciprocal, blocks);
}

/// One function for all tables: choosing the method costs nothing compared with a reciprocal.
template <Texturing How>
[[gnu::noinline]] std::span<const Span> cut_by_table(std::span<const Span> spans, std::int32_t pitch,
                                                     const BlockCutting& cutting, TabledReciprocal reciprocal,
                                                     BlockList& blocks) {
    return cut_in_range<How>(spans, pitch, cutting, reciprocal, blocks);
}

template <Texturing How, ReciprocalMethod Method>
std::span<const Span> append_blocks(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                    BlockList& blocks) {
    if constexpr (Method == ReciprocalMethod::Exact)
        return cut_in_range<How>(spans, pitch, cutting, DividedReciprocal{}, blocks);
    else
        return cut_by_table<How>(spans, pitch, cutting, TabledReciprocal{Method}, blocks);
}

/// The same code for processors with BMI2, whose shifts take their count from any register. For the default settings
/// only; others are not worth the code size.
OBLONG_TARGET_BMI2 std::span<const Span> append_bounded_bmi2(std::span<const Span> spans, std::int32_t pitch,
                                                             const BlockCutting& cutting, BlockList& blocks) {
    return cut_in_range<Texturing::Bounded>(spans, pitch, cutting, DividedReciprocal{}, blocks);
}

constexpr std::size_t kTexturingCount = as_size(Texturing::Exact) + 1;

/// append_blocks() by method, then by texturing.
template <std::size_t... kCells>
constexpr std::array<BlockCutter, sizeof...(kCells)> make_cutters(std::index_sequence<kCells...>) {
    return {append_blocks<static_cast<Texturing>(kCells % kTexturingCount),
                          static_cast<ReciprocalMethod>(kCells / kTexturingCount)>...};
}
constexpr auto kCutters = make_cutters(std::make_index_sequence<kTexturingCount * kReciprocalMethods.size()>());

}  // namespace

TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px) {
    // A floored step loses less than 2^-16 texel a pixel: with this inset no sample drifts below 0.
    return {Texel::from_raw(longest_px), Texel::from_int(width) - Texel::ulp(), Texel::from_int(height) - Texel::ulp()};
}

TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row) {
    const Perspective at = Perspective::at(gradients, column, row);
    return texel_of(at, Depth<DividedReciprocal, PerspectiveRange::MayOverflow>(at.inverse_z, {}), limits);
}

namespace {

/// For spans of one block each: how many ends are in the same column as the one before (SpanEnds).
std::int64_t repeated_ends(std::span<const Span> spans) {
    std::int64_t count = 0;
    std::int32_t first = -1, end = -1;
    for (const Span& span : spans) {
        count += span.first == std::exchange(first, span.first);
        if (span.end - span.first > 1) count += span.end == std::exchange(end, span.end);
    }
    return count;
}

}  // namespace

std::int64_t divisions_of(std::span<const Span> spans, const BlockCutting& cutting, const BlockList& blocks) {
    const TextureGradients& gradients = cutting.gradients;
    if (gradients.inverse_z.per_column == InverseZ{}) return std::ssize(spans);
    std::int64_t divisions = std::ssize(spans) + blocks.extra_divisions();
    const TexelBlock* block = blocks.waiting().data();
    for (const Span& span : spans)
        for (std::int32_t left = span.end - span.first; left > 0; left -= block++->count) divisions += left > 1;
    const bool repeats_ends = cutting.takes_whole_spans && RowRepeater<DividedReciprocal>::serves(gradients);
    return repeats_ends ? divisions - repeated_ends(spans) : divisions;
}

BlockCutter block_cutter(const Accuracy& accuracy, Instructions instructions) {
    const bool is_default = accuracy.texturing == Texturing::Bounded && accuracy.reciprocal == ReciprocalMethod::Exact;
    if (is_default && instructions == Instructions::Bmi2) return append_bounded_bmi2;
    return kCutters[as_size(accuracy.reciprocal) * kTexturingCount + as_size(accuracy.texturing)];
}

}  // namespace oblong
