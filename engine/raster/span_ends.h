#pragma once

#include <cstdint>

#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// Texels at the ends of spans of one block each.
template <class Reciprocal, PerspectiveRange Range>
class SpanEnds {
  public:
    [[gnu::always_inline]] SpanEnds(const BlockCutting& cutting, Reciprocal reciprocal)
        : gradients_(cutting.gradients),
          limits_(cutting.limits),
          reciprocal_(reciprocal),
          is_of_one_depth_(cutting.gradients.inverse_z.per_column == InverseZ{}) {}

    [[gnu::always_inline]] TexelPosition first(const Span& span) {
        here_.inverse_z = value_at<Range>(gradients_.inverse_z, span.first, span.y);
        depth_ = FittingDepth(here_.inverse_z, reciprocal_);
        here_.u_over_z = value_at<Range>(gradients_.u_over_z, span.first, span.y);
        const std::uint32_t u_16 = depth_.times(here_.u_over_z, limits_.least, limits_.greatest_u);
        here_.v_over_z = value_at<Range>(gradients_.v_over_z, span.first, span.y);
        return {u_16, depth_.times(here_.v_over_z, limits_.least, limits_.greatest_v)};
    }
    /// Call after first(), for the same span.
    [[gnu::always_inline]] TexelPosition last(const Span& span) {
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

/// The same if 1/z and u are the same in all rows (RowRepeater), as on walls in a level view: an end in the same column
/// as in the row above differs in v only.
template <class Reciprocal, PerspectiveRange Range>
class RepeatedSpanEnds {
  public:
    [[gnu::always_inline]] RepeatedSpanEnds(const BlockCutting& cutting, Reciprocal reciprocal)
        : gradients_(cutting.gradients),
          limits_(cutting.limits),
          reciprocal_(reciprocal),
          is_of_one_depth_(cutting.gradients.inverse_z.per_column == InverseZ{}) {}

    [[gnu::always_inline]] TexelPosition first(const Span& span) {
        if (span.first != first_.column) set(first_, span.first, span.y, depth_at(span.first, span.y));
        return {first_.u_16, v_16(first_, span.y)};
    }
    /// Call after first(), for a span of at least two pixels.
    [[gnu::always_inline]] TexelPosition last(const Span& span) {
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

    [[gnu::always_inline]] void set(End& end, std::int32_t column, std::int32_t row, const FittingDepth& depth) const {
        end = {column,
               depth.times(value_at<Range>(gradients_.u_over_z, column, row), limits_.least, limits_.greatest_u),
               depth};
    }
    [[gnu::always_inline]] FittingDepth depth_at(std::int32_t column, std::int32_t row) const {
        return FittingDepth(value_at<Range>(gradients_.inverse_z, column, row), reciprocal_);
    }
    [[gnu::always_inline]] std::uint32_t v_16(const End& end, std::int32_t row) const {
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
