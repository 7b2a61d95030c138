#include "engine/raster/texture_blocks.h"

#include <array>
#include <utility>

#include "engine/raster/cut_blocks.h"

namespace oblong {

namespace {

/// One function for all tables: choosing the method costs nothing compared with a reciprocal.
template <Texturing How>
[[gnu::noinline, gnu::flatten]] std::span<const Span> cut_by_table(std::span<const Span> spans, std::int32_t pitch,
                                                                   const BlockCutting& cutting,
                                                                   TabledReciprocal reciprocal, BlockList& blocks) {
    return cut_in_range<How>(spans, pitch, cutting, reciprocal, blocks);
}

template <Texturing How, ReciprocalMethod Method>
[[gnu::flatten]] std::span<const Span> append_blocks(std::span<const Span> spans, std::int32_t pitch,
                                                     const BlockCutting& cutting, BlockList& blocks) {
    if constexpr (Method == ReciprocalMethod::Exact)
        return cut_in_range<How>(spans, pitch, cutting, DividedReciprocal{}, blocks);
    else
        return cut_by_table<How>(spans, pitch, cutting, TabledReciprocal{Method}, blocks);
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

BlockCutter block_cutter(const Accuracy& accuracy, const Kernels& kernels) {
    const bool is_default = accuracy.texturing == Texturing::Bounded && accuracy.reciprocal == ReciprocalMethod::Exact;
    if (is_default && kernels.cut_bounded) return kernels.cut_bounded;
    return kCutters[as_size(accuracy.reciprocal) * kTexturingCount + as_size(accuracy.texturing)];
}

}  // namespace oblong
