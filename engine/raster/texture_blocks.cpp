#include "engine/raster/texture_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <tuple>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"

#if defined(__x86_64__)
#define OBLONG_TARGET_BMI2 [[gnu::target("bmi2,lzcnt")]]
#else
#define OBLONG_TARGET_BMI2
#endif

namespace oblong {

namespace {

/// Cuts spans of one surface into blocks, left to right. Each block ends where the next begins, so a division serves
/// twice. Its functions are force-inlined, so that its members stay in registers.
template <class Reciprocal, PerspectiveRange Range>
class SpanCutter {
  public:
    [[gnu::always_inline]] SpanCutter(const BlockCutting& cutting, Reciprocal reciprocal, TexelBlock* out)
        : gradients_(cutting.gradients), limits_(cutting.limits), reciprocal_(reciprocal), out_(out) {}

    [[gnu::always_inline]] void start(const Span& span, std::int32_t pitch) {
        left_ = span.end - span.first;
        pixel_ = static_cast<std::uint32_t>(span.y * pitch + span.first);
        here_ = Perspective(gradients_, span.first, span.y);
        depth_ = Depth<Reciprocal, Range>(here_.inverse_z, reciprocal_);
        texel_ = texel_of(here_, depth_, limits_);
    }

    std::int32_t left() const { return left_; }
    InverseZ inverse_z() const { return here_.inverse_z; }
    TexelBlock* end() const { return out_; }
    void set_end(TexelBlock* end) { out_ = end; }
    std::int64_t tries() const { return tries_; }

    /// A block of 2^log2 pixels, all of them in the span.
    [[gnu::always_inline]] void cut_power(int log2) {
        const TexelPosition from = texel_;
        advance(std::int32_t{1} << log2);
        append(1 << log2, from, steps_by_shift(from, texel_, log2));
    }

    /// The last block, of the remaining pixels (1 or more). It ends at the span's last pixel: beyond may lie the end of
    /// the surface, or the horizon of its plane.
    [[gnu::always_inline]] void cut_rest() {
        const std::int32_t steps = left_ - 1;
        if (steps == 0) return append(1, texel_, {});
        const TexelPosition from = texel_;
        advance(steps);
        append(steps + 1, from, steps_by_division(from, texel_, steps));
    }

    /// A block of 2^log2 pixels, or the last one, if it keeps u and v within `bound_256` of the truth; else nothing. A
    /// block of one or two pixels always does.
    [[gnu::always_inline]] bool try_block(int log2, std::int32_t bound_256) {
        const std::int32_t size = std::int32_t{1} << log2, steps = std::min(size, left_ - 1);
        const auto start = std::tuple(here_, depth_, texel_);
        const TexelPosition from = texel_;
        advance(steps);
        ++tries_;
        const bool is_within = steps < 2 || is_straight(std::get<Perspective>(start).inverse_z, from, steps, bound_256);
        std::tie(here_, depth_, texel_) = start;
        if (is_within && steps == size) cut_power(log2);
        if (is_within && steps < size) cut_rest();
        return is_within;
    }

  private:
    /// Whether the texels between `from` and here lie within a bound of a straight line. With k the ratio of the two
    /// ends' 1/z, the line is off by |du| (sqrt k - 1) / (sqrt k + 1) <= |du| (k - 1) / 4 at most; a step that is
    /// floored loses less than 2^-16 texel a pixel.
    bool is_straight(InverseZ from_z, TexelPosition from, std::int32_t steps, std::int32_t bound_256) const {
        const InverseZ least = std::min(from_z, here_.inverse_z);
        if (least < kLeastInverseZ) return false;
        const InverseZ rise = absolute(here_.inverse_z - from_z);
        const int shift = std::max(static_cast<int>(std::bit_width(least.bits())) - 28, 0);
        const std::int64_t room_16 = std::int64_t{bound_256} * 256 - steps - 4;
        const std::int64_t rise_in_steps = floor_shift(rise, shift).raw + 1;
        if (room_16 < 0 || rise_in_steps >= std::int64_t{1} << 31) return false;
        const std::int64_t texels_16 =
            std::max(std::abs(std::int64_t{texel_.u_16} - from.u_16), std::abs(std::int64_t{texel_.v_16} - from.v_16));
        return texels_16 * rise_in_steps <= 4 * room_16 * floor_shift(least, shift).raw;
    }

    [[gnu::always_inline]] void advance(std::int32_t count) {
        const InverseZ before = here_.inverse_z;
        const auto columns = static_cast<std::uint32_t>(count);
        here_.inverse_z = stepped(before, gradients_.inverse_z.per_column, columns);
        here_.u_over_z = stepped(here_.u_over_z, gradients_.u_over_z.per_column, columns);
        here_.v_over_z = stepped(here_.v_over_z, gradients_.v_over_z.per_column, columns);
        if (here_.inverse_z != before) depth_ = Depth<Reciprocal, Range>(here_.inverse_z, reciprocal_);
        texel_ = texel_of(here_, depth_, limits_);
    }

    [[gnu::always_inline]] void append(std::int32_t count, TexelPosition from, TexelStep step) {
        *out_++ = {pixel_, count, from.u_16, from.v_16, step.u_16, step.v_16};
        pixel_ += static_cast<std::uint32_t>(count);
        left_ -= count;
    }

    const TextureGradients gradients_;
    const TexelLimits limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    TexelBlock* out_;
    std::int32_t left_ = 0;
    std::uint32_t pixel_ = 0;
    Perspective here_;
    Depth<Reciprocal, Range> depth_;
    TexelPosition texel_;
    std::int64_t tries_ = 0;  ///< of try_block()
};

template <class Cutter>
[[gnu::always_inline]] inline void cut_every(Cutter& cutter, int log2) {
    while (cutter.left() > 1 << log2) cutter.cut_power(log2);
    cutter.cut_rest();
}

/// Blocks as long as the bound allows where they begin. The search for that begins at the last block's size.
template <class Cutter>
[[gnu::always_inline]] inline void cut_bounded(Cutter& cutter, const BlockThresholds& thresholds, std::int64_t& log2) {
    const auto& least = thresholds.least_inverse_z;
    while (true) {
        while (cutter.inverse_z() >= item(least, log2 + 1)) ++log2;
        while (cutter.inverse_z() < item(least, log2)) --log2;
        if (cutter.left() <= 1 << log2) return cutter.cut_rest();
        cutter.cut_power(static_cast<int>(log2));
    }
}

/// Tries a block twice as long as the last one, then halves it until it is within the bound.
template <class Cutter>
[[gnu::always_inline]] inline void cut_bounded_texels(Cutter& cutter, std::int32_t bound_256) {
    int log2 = 3;
    while (cutter.left() > 1) {
        while (!cutter.try_block(log2, bound_256)) --log2;
        log2 = std::min(log2 + 1, kBlockSizes - 1);
    }
    if (cutter.left() == 1) cutter.cut_rest();
}

template <Texturing Way, class Cutter>
[[gnu::always_inline]] inline void cut_span(Cutter& cutter, const BlockCutting& cutting, std::int64_t& log2) {
    if constexpr (Way == Texturing::Affine) cutter.cut_rest();
    if constexpr (Way == Texturing::Every32) cut_every(cutter, 5);
    if constexpr (Way == Texturing::Every16) cut_every(cutter, 4);
    if constexpr (Way == Texturing::Every8) cut_every(cutter, 3);
    if constexpr (Way == Texturing::Bounded) cut_bounded(cutter, cutting.thresholds, log2);
    if constexpr (Way == Texturing::BoundedTexels) cut_bounded_texels(cutter, cutting.texel_bound_256);
    if constexpr (Way == Texturing::Exact) cut_every(cutter, 0);
}

/// Returns the spans that are left.
template <Texturing Way, PerspectiveRange Range, class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_spans(std::span<const Span> spans, std::int32_t pitch,
                                                              const BlockCutting& cutting, Reciprocal reciprocal,
                                                              BlockList& blocks) {
    SpanCutter<Reciprocal, Range> cutter(cutting, reciprocal, blocks.end());
    const TexelBlock* const full = blocks.full();
    std::int64_t log2 = 0;
    const Span* span = spans.data();
    const Span* const end = span + spans.size();
    for (; span != end && cutter.end() <= full; ++span) {
        cutter.start(*span, pitch);
        cut_span<Way>(cutter, cutting, log2);
    }
    blocks.set_end(cutter.end());
    if constexpr (Way == Texturing::BoundedTexels) blocks.add_divisions(cutter.tries());
    return {span, end};
}

/// The same for RowRepeater's surfaces.
template <class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_repeating_rows(std::span<const Span> spans, std::int32_t pitch,
                                                                       const BlockCutting& cutting,
                                                                       Reciprocal reciprocal, BlockList& blocks) {
    SpanCutter<Reciprocal, PerspectiveRange::Fits> cutter(cutting, reciprocal, blocks.end());
    RowRepeater<Reciprocal> repeater(cutting.gradients, cutting.limits, reciprocal);
    const TexelBlock* const full = blocks.full();
    std::int64_t log2 = 0;
    const Span* span = spans.data();
    const Span* const end = span + spans.size();
    for (; span != end && cutter.end() <= full; ++span) {
        if (repeater.can_repeat(*span)) {
            cutter.set_end(repeater.repeat(*span, pitch, cutter.end()));
            continue;
        }
        const TexelBlock* const first = cutter.end();
        cutter.start(*span, pitch);
        cut_bounded(cutter, cutting.thresholds, log2);
        repeater.remember(*span, {first, cutter.end()});
    }
    blocks.set_end(cutter.end());
    blocks.add_divisions(-repeater.divisions_saved());
    return {span, end};
}

/// Texels at the ends of spans that are one block each. Where 1/z and u are the same in all rows, as a wall's are in a
/// level view, they are those of the row above in the same column, but for v.
template <class Reciprocal>
class SpanEnds {
  public:
    [[gnu::always_inline]] SpanEnds(const BlockCutting& cutting, Reciprocal reciprocal)
        : gradients_(cutting.gradients),
          limits_(cutting.limits),
          reciprocal_(reciprocal),
          repeats_rows_(RowRepeater<Reciprocal>::serves(cutting.gradients)),
          is_of_one_depth_(cutting.gradients.inverse_z.per_column == InverseZ{}) {}

    [[gnu::always_inline]] TexelPosition first(const Span& span) {
        if (!repeats_rows_ || span.first != first_.column)
            set(first_, span.first, span.y, depth_at(span.first, span.y));
        else
            ++divisions_saved_;
        return {first_.u_16, v_16(first_, span.y)};
    }
    /// After first(), of a span of two pixels at least.
    [[gnu::always_inline]] TexelPosition last(const Span& span) {
        const std::int32_t column = span.end - 1;
        if (is_of_one_depth_)
            set(last_, column, span.y, first_.depth);
        else if (!repeats_rows_ || column != last_.column)
            set(last_, column, span.y, depth_at(column, span.y));
        else
            ++divisions_saved_;
        return {last_.u_16, v_16(last_, span.y)};
    }
    std::int64_t divisions_saved() const { return divisions_saved_; }

  private:
    using FittingDepth = Depth<Reciprocal, PerspectiveRange::Fits>;
    struct End {
        std::int32_t column = -1;
        std::uint32_t u_16 = 0;
        FittingDepth depth;
    };

    [[gnu::always_inline]] void set(End& end, std::int32_t column, std::int32_t row, const FittingDepth& depth) const {
        end = {column, within(depth.times(gradients_.u_over_z.at_shown(column, row)), limits_.greatest_u), depth};
    }
    [[gnu::always_inline]] FittingDepth depth_at(std::int32_t column, std::int32_t row) const {
        return FittingDepth(gradients_.inverse_z.at_shown(column, row), reciprocal_);
    }
    [[gnu::always_inline]] std::uint32_t v_16(const End& end, std::int32_t row) const {
        return within(end.depth.times(gradients_.v_over_z.at_shown(end.column, row)), limits_.greatest_v);
    }
    [[gnu::always_inline]] std::uint32_t within(Texel texel, Texel greatest) const {
        return texel_within(texel, limits_.least, greatest);
    }

    const TextureGradients gradients_;
    const TexelLimits limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    const bool repeats_rows_, is_of_one_depth_;
    End first_, last_;
    std::int64_t divisions_saved_ = 0;
};

/// Spans that are one block each.
template <class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_whole_spans(std::span<const Span> spans, std::int32_t pitch,
                                                                    const BlockCutting& cutting, Reciprocal reciprocal,
                                                                    BlockList& blocks) {
    SpanEnds<Reciprocal> ends(cutting, reciprocal);
    const Span* span = spans.data();
    const Span* const end = span + spans.size();
    TexelBlock* out = blocks.end();
    for (const TexelBlock* const full = blocks.full(); span != end && out <= full; ++span) {
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
    blocks.add_divisions(-ends.divisions_saved());
    return {span, end};
}

template <Texturing Way, class Reciprocal>
[[gnu::always_inline]] inline std::span<const Span> cut_in_range(std::span<const Span> spans, std::int32_t pitch,
                                                                 const BlockCutting& cutting, Reciprocal reciprocal,
                                                                 BlockList& blocks) {
    using enum PerspectiveRange;
    if (!cutting.fits_range) return cut_spans<Way, MayOverflow>(spans, pitch, cutting, reciprocal, blocks);
    if (Way == Texturing::Bounded && cutting.takes_whole_spans)
        return cut_whole_spans(spans, pitch, cutting, reciprocal, blocks);
    if (Way == Texturing::Bounded && RowRepeater<Reciprocal>::serves(cutting.gradients))
        return cut_repeating_rows(spans, pitch, cutting, reciprocal, blocks);
    return cut_spans<Way, Fits>(spans, pitch, cutting, reciprocal, blocks);
}

/// One function for all tables: asking for the method costs nothing beside finding a reciprocal.
template <Texturing Way>
[[gnu::noinline]] std::span<const Span> cut_by_table(std::span<const Span> spans, std::int32_t pitch,
                                                     const BlockCutting& cutting, TabledReciprocal reciprocal,
                                                     BlockList& blocks) {
    return cut_in_range<Way>(spans, pitch, cutting, reciprocal, blocks);
}

template <Texturing Way, ReciprocalMethod Method>
std::span<const Span> append_blocks(std::span<const Span> spans, std::int32_t pitch, const BlockCutting& cutting,
                                    BlockList& blocks) {
    if constexpr (Method == ReciprocalMethod::Exact)
        return cut_in_range<Way>(spans, pitch, cutting, DividedReciprocal{}, blocks);
    else
        return cut_by_table<Way>(spans, pitch, cutting, TabledReciprocal{Method}, blocks);
}

/// The same code for processors with BMI2, whose shifts take their count from any register. The defaults alone: other
/// settings are not worth the room.
OBLONG_TARGET_BMI2 std::span<const Span> append_bounded_bmi2(std::span<const Span> spans, std::int32_t pitch,
                                                             const BlockCutting& cutting, BlockList& blocks) {
    return cut_in_range<Texturing::Bounded>(spans, pitch, cutting, DividedReciprocal{}, blocks);
}

template <ReciprocalMethod Method>
BlockCutter cutter_by(Texturing texturing) {
    switch (texturing) {
        case Texturing::Affine:
            return append_blocks<Texturing::Affine, Method>;
        case Texturing::Every32:
            return append_blocks<Texturing::Every32, Method>;
        case Texturing::Every16:
            return append_blocks<Texturing::Every16, Method>;
        case Texturing::Every8:
            return append_blocks<Texturing::Every8, Method>;
        case Texturing::Bounded:
            return append_blocks<Texturing::Bounded, Method>;
        case Texturing::BoundedTexels:
            return append_blocks<Texturing::BoundedTexels, Method>;
        case Texturing::Exact:
            break;
    }
    return append_blocks<Texturing::Exact, Method>;
}

}  // namespace

TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px) {
    // Flooring a step loses less than a unit of 2^-16 a pixel: from this inset no sample drifts below 0.
    return {Texel::from_raw(longest_px), Texel::from_int(width) - Texel::ulp(), Texel::from_int(height) - Texel::ulp()};
}

TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row) {
    const Perspective at(gradients, column, row);
    return texel_of(at, Depth<DividedReciprocal, PerspectiveRange::MayOverflow>(at.inverse_z, {}), limits);
}

std::int64_t divisions_of(std::span<const Span> spans, const TextureGradients& gradients, const BlockList& blocks) {
    if (gradients.inverse_z.per_column == InverseZ{}) return std::ssize(spans);
    std::int64_t divisions = std::ssize(spans) + blocks.more_divisions();
    const TexelBlock* block = blocks.waiting().data();
    for (const Span& span : spans)
        for (std::int32_t left = span.end - span.first; left > 0; left -= block++->count) divisions += left > 1;
    return divisions;
}

BlockCutter block_cutter(const Accuracy& accuracy, bool has_bmi2) {
    switch (accuracy.reciprocal) {
        case ReciprocalMethod::Table256:
            return cutter_by<ReciprocalMethod::Table256>(accuracy.texturing);
        case ReciprocalMethod::Table256Newton:
            return cutter_by<ReciprocalMethod::Table256Newton>(accuracy.texturing);
        case ReciprocalMethod::Table1024Newton:
            return cutter_by<ReciprocalMethod::Table1024Newton>(accuracy.texturing);
        case ReciprocalMethod::Table256TwoNewton:
            return cutter_by<ReciprocalMethod::Table256TwoNewton>(accuracy.texturing);
        case ReciprocalMethod::Exact:
            break;
    }
    if (accuracy.texturing == Texturing::Bounded && has_bmi2) return append_bounded_bmi2;
    return cutter_by<ReciprocalMethod::Exact>(accuracy.texturing);
}

}  // namespace oblong
