#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"

namespace oblong {

/// Cuts rows of a surface whose 1/z and u are the same in all rows, as on walls in a view without pitch and roll. In a
/// row with the same columns as one above, blocks have the same lengths, depths and u; only v differs.
template <class Reciprocal>
class RowRepeater {
  public:
    static bool serves(const TextureGradients& gradients) {
        return gradients.inverse_z.per_row == InverseZ{} && gradients.u_over_z.per_row == TexelOverZ{};
    }

    /// For rows with the columns of `above`. `blocks` are kMostBlocks at most and must outlive this.
    RowRepeater(const Span& above, std::span<const TexelBlock> blocks, const BlockCutting& cutting,
                Reciprocal reciprocal)
        : above_(above), blocks_(blocks), gradients_(cutting.gradients), limits_(cutting.limits) {
        find_depths(reciprocal);
    }

    /// Appends the blocks of a row. Returns the list's new end.
    TexelBlock* repeat(std::int32_t row, std::int32_t pitch, TexelBlock* out) const {
        const auto down = static_cast<std::uint32_t>((row - above_.y) * pitch);
        TexelOverZ v_over_z = gradients_.v_over_z.at(above_.first, row);
        const BlockDepth* depth = depths_.data();
        std::uint32_t v_16 = v_at(v_over_z, *depth);
        const TexelBlock* above = blocks_.data();
        for (const TexelBlock* const last = above + blocks_.size() - 1; above != last; ++above) {
            v_over_z = stepped(v_over_z, gradients_.v_over_z.per_column, above->count);
            const std::uint32_t to_16 = v_at(v_over_z, *++depth);
            const int log2 = std::countr_zero(static_cast<std::uint32_t>(above->count));
            *out++ = moved(*above, down, v_16, steps_by_shift({0, v_16}, {0, to_16}, log2).v_16);
            v_16 = to_16;
        }
        const std::int32_t steps = above->count - 1;
        v_over_z = stepped(v_over_z, gradients_.v_over_z.per_column, steps);
        const std::uint32_t to_16 = v_at(v_over_z, *++depth);
        *out++ = moved(*above, down, v_16, steps == 0 ? 0 : steps_by_division({0, v_16}, {0, to_16}, steps).v_16);
        return out;
    }

    static constexpr std::size_t kMostBlocks = 63;

  private:
    using FittingDepth = Depth<Reciprocal, PerspectiveRange::Fits>;
    struct BlockDepth {
        decltype(FittingDepth::mantissa) mantissa;
        int shift;
    };

    /// At the first pixel of each block and the last pixel of the row.
    void find_depths(Reciprocal reciprocal) {
        std::size_t count = 0;
        const auto add = [&](std::int32_t column) {
            const FittingDepth depth(gradients_.inverse_z.at(column, above_.y), reciprocal);
            item(depths_, count++) = {depth.mantissa, depth.shift};
        };
        std::int32_t column = above_.first;
        for (const TexelBlock& block : blocks_) {
            add(column);
            column += block.count;
        }
        add(column - 1);
    }

    std::uint32_t v_at(TexelOverZ v_over_z, const BlockDepth& known) const {
        FittingDepth depth;
        depth.mantissa = known.mantissa;
        depth.shift = known.shift;
        return depth.times(v_over_z, limits_.least, limits_.greatest_v);
    }

    static TexelBlock moved(const TexelBlock& block, std::uint32_t pixels, std::uint32_t v_16, std::int32_t v_step_16) {
        return {block.pixel + pixels, block.count, block.u_16, v_16, block.u_step_16, v_step_16};
    }

    const Span& above_;
    const std::span<const TexelBlock> blocks_;
    const TextureGradients& gradients_;
    const TexelLimits& limits_;
    std::array<BlockDepth, kMostBlocks + 1> depths_;
};

}  // namespace oblong
