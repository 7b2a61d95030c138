#pragma once

#include <cstdint>

#include "engine/raster/perspective.h"
#include "engine/raster/row_repeater.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// Texels at the ends of spans of one block each. If 1/z and u are the same in all rows, as on walls in a level view,
/// an end in the same column as in the row above differs in v only.
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
        return {first_.u_16, v_16(first_, span.y)};
    }
    /// Call after first(), for a span of at least two pixels.
    [[gnu::always_inline]] TexelPosition last(const Span& span) {
        const std::int32_t column = span.end - 1;
        if (is_of_one_depth_)
            set(last_, column, span.y, first_.depth);
        else if (!repeats_rows_ || column != last_.column)
            set(last_, column, span.y, depth_at(column, span.y));
        return {last_.u_16, v_16(last_, span.y)};
    }

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
};

}  // namespace oblong
