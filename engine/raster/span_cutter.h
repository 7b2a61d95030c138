#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// Cuts spans of one surface into blocks, left to right. Each block ends where the next begins, so they share a
/// division. Forced inlining keeps the members in registers.
template <class Reciprocal, PerspectiveRange Range>
class SpanCutter {
  public:
    SpanCutter(const BlockCutting& cutting, Reciprocal reciprocal, TexelBlock* out)
        : gradients_(cutting.gradients), limits_(cutting.limits), reciprocal_(reciprocal), out_(out) {}

    void start(const Span& span, std::int32_t pitch) {
        remaining_px_ = span.end - span.first;
        pixel_ = static_cast<std::uint32_t>(span.y * pitch + span.first);
        here_ = Perspective::at<Range>(gradients_, span.first, span.y);
        depth_ = Depth<Reciprocal, Range>(here_.inverse_z, reciprocal_);
        texel_ = texel_of(here_, depth_, limits_);
    }

    /// Pixels of the span not cut yet.
    std::int32_t remaining() const { return remaining_px_; }
    InverseZ inverse_z() const { return here_.inverse_z; }
    TexelBlock* end() const { return out_; }
    void set_end(TexelBlock* end) { out_ = end; }
    std::int64_t tries() const { return tries_; }

    /// Cuts a block of 2^log2 pixels, all in the span.
    void cut_power(int log2) {
        const TexelPosition from = texel_;
        advance_by([log2](auto value, auto step) { return stepped_by_power<Range>(value, step, log2); });
        append(1 << log2, from, steps_by_shift(from, texel_, log2));
    }

    /// Cuts the last block, of the remaining pixels (1 or more). It ends at the span's last pixel: beyond may be the
    /// end of the surface, or the horizon of its plane.
    void cut_rest() {
        const std::int32_t steps = remaining_px_ - 1;
        if (steps == 0) return append(1, texel_, {});
        const TexelPosition from = texel_;
        advance(steps);
        append(steps + 1, from, steps_by_division(from, texel_, steps));
    }

    /// Cuts a block of 2^log2 pixels, or the last one, if it keeps the error of u and v within `bound_256`, which
    /// blocks of one or two pixels always do. Returns whether it was cut.
    bool try_block(int log2, std::int32_t bound_256) {
        const std::int32_t size = std::int32_t{1} << log2, steps = std::min(size, remaining_px_ - 1);
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
    /// Whether the texels between `from` and here are within a bound of a straight line. With k the ratio of the ends'
    /// 1/z, the line's error is at most |du| (sqrt k - 1) / (sqrt k + 1) <= |du| (k - 1) / 4; a floored step loses less
    /// than 2^-16 texel a pixel.
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

    void advance(std::int32_t count) {
        const auto columns = static_cast<std::uint32_t>(count);
        advance_by([columns](auto value, auto step) { return stepped_in<Range>(value, step, columns); });
    }
    /// stepped(value, step per column) is the value some columns further on.
    template <class Stepped>
    void advance_by(Stepped stepped) {
        const InverseZ before = here_.inverse_z;
        here_.inverse_z = stepped(before, gradients_.inverse_z.per_column);
        here_.u_over_z = stepped(here_.u_over_z, gradients_.u_over_z.per_column);
        here_.v_over_z = stepped(here_.v_over_z, gradients_.v_over_z.per_column);
        if (here_.inverse_z != before) depth_ = Depth<Reciprocal, Range>(here_.inverse_z, reciprocal_);
        texel_ = texel_of(here_, depth_, limits_);
    }

    void append(std::int32_t count, TexelPosition from, TexelStep step) {
        *out_++ = {pixel_, count, from.u_16, from.v_16, step.u_16, step.v_16};
        pixel_ += static_cast<std::uint32_t>(count);
        remaining_px_ -= count;
    }

    const TextureGradients gradients_;
    const TexelLimits limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    TexelBlock* out_;
    std::int32_t remaining_px_ = 0;
    std::uint32_t pixel_ = 0;
    Perspective here_;
    Depth<Reciprocal, Range> depth_;
    TexelPosition texel_;
    std::int64_t tries_ = 0;  ///< calls of try_block()
};

/// Texels at the ends of spans of one block each.
template <class Reciprocal, PerspectiveRange Range>
class SpanEnds {
  public:
    SpanEnds(const BlockCutting& cutting, Reciprocal reciprocal)
        : gradients_(cutting.gradients),
          limits_(cutting.limits),
          reciprocal_(reciprocal),
          is_of_one_depth_(cutting.gradients.inverse_z.per_column == InverseZ{}) {}

    TexelPosition first(const Span& span) {
        here_.inverse_z = value_at<Range>(gradients_.inverse_z, span.first, span.y);
        depth_ = FittingDepth(here_.inverse_z, reciprocal_);
        here_.u_over_z = value_at<Range>(gradients_.u_over_z, span.first, span.y);
        const std::uint32_t u_16 = depth_.times(here_.u_over_z, limits_.least, limits_.greatest_u);
        here_.v_over_z = value_at<Range>(gradients_.v_over_z, span.first, span.y);
        return {u_16, depth_.times(here_.v_over_z, limits_.least, limits_.greatest_v)};
    }
    /// Call after first(), for the same span.
    TexelPosition last(const Span& span) {
        const auto columns = static_cast<std::uint32_t>(span.end - 1 - span.first);
        if (!is_of_one_depth_)
            depth_ =
                FittingDepth(stepped_in<Range>(here_.inverse_z, gradients_.inverse_z.per_column, columns), reciprocal_);
        const TexelOverZ u_over_z = stepped_in<Range>(here_.u_over_z, gradients_.u_over_z.per_column, columns);
        const std::uint32_t u_16 = depth_.times(u_over_z, limits_.least, limits_.greatest_u);
        const TexelOverZ v_over_z = stepped_in<Range>(here_.v_over_z, gradients_.v_over_z.per_column, columns);
        return {u_16, depth_.times(v_over_z, limits_.least, limits_.greatest_v)};
    }

  private:
    using FittingDepth = Depth<Reciprocal, Range>;

    const TextureGradients gradients_;
    const TexelLimits limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    const bool is_of_one_depth_;
    Perspective here_;
    FittingDepth depth_;
};

/// The same if 1/z and u are the same in all rows (RowRepeater), as on walls in a view without pitch and roll: an end
/// in the same column as in the row above differs in v only.
template <class Reciprocal, PerspectiveRange Range>
class RepeatedSpanEnds {
  public:
    RepeatedSpanEnds(const BlockCutting& cutting, Reciprocal reciprocal)
        : gradients_(cutting.gradients),
          limits_(cutting.limits),
          reciprocal_(reciprocal),
          is_of_one_depth_(cutting.gradients.inverse_z.per_column == InverseZ{}) {}

    TexelPosition first(const Span& span) {
        if (span.first != first_.column) set(first_, span.first, span.y, depth_at(span.first, span.y));
        return {first_.u_16, v_16(first_, span.y)};
    }
    /// Call after first(), for a span of at least two pixels.
    TexelPosition last(const Span& span) {
        const std::int32_t column = span.end - 1;
        if (is_of_one_depth_)
            set(last_, column, span.y, first_.depth);
        else if (column != last_.column)
            set(last_, column, span.y, depth_at(column, span.y));
        return {last_.u_16, v_16(last_, span.y)};
    }

  private:
    using FittingDepth = Depth<Reciprocal, Range>;
    struct End {
        std::int32_t column = -1;
        std::uint32_t u_16 = 0;
        FittingDepth depth;
    };

    void set(End& end, std::int32_t column, std::int32_t row, const FittingDepth& depth) const {
        end = {column,
               depth.times(value_at<Range>(gradients_.u_over_z, column, row), limits_.least, limits_.greatest_u),
               depth};
    }
    FittingDepth depth_at(std::int32_t column, std::int32_t row) const {
        return FittingDepth(value_at<Range>(gradients_.inverse_z, column, row), reciprocal_);
    }
    std::uint32_t v_16(const End& end, std::int32_t row) const {
        return end.depth.times(value_at<Range>(gradients_.v_over_z, end.column, row), limits_.least,
                               limits_.greatest_v);
    }

    const TextureGradients gradients_;
    const TexelLimits limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    const bool is_of_one_depth_;
    End first_, last_;
};

}  // namespace oblong
