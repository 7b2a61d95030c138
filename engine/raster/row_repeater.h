#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"

namespace oblong {

/// Cuts rows of a surface whose 1/z and u are the same in all rows, as a wall's are in a level view. Between the same
/// columns as in a row before, blocks have the same lengths, ends of the same depth, and the same u: v alone is
/// another.
template <class Reciprocal>
class RowRepeater {
  public:
    static bool serves(const TextureGradients& gradients) {
        return gradients.inverse_z.per_row == InverseZ{} && gradients.u_over_z.per_row == TexelOverZ{};
    }

    [[gnu::always_inline]] RowRepeater(const TextureGradients& gradients, const TexelLimits& limits,
                                       Reciprocal reciprocal)
        : gradients_(gradients), limits_(limits), reciprocal_(reciprocal) {}

    /// Remembers the blocks of a span, which must stay where they are.
    [[gnu::always_inline]] void remember(const Span& span, std::span<const TexelBlock> blocks) {
        span_ = span;
        blocks_ = blocks;
        knows_depths_ = false;
    }

    [[gnu::always_inline]] bool can_repeat(const Span& span) const {
        return span.first == span_.first && span.end == span_.end && blocks_.size() < kMostEnds;
    }

    /// Appends the blocks of a span that it can repeat. Returns the list's new end.
    [[gnu::always_inline]] TexelBlock* repeat(const Span& span, std::int32_t pitch, TexelBlock* out) {
        if (!knows_depths_) find_depths();
        const auto down = static_cast<std::uint32_t>((span.y - span_.y) * pitch);
        TexelOverZ v_over_z = gradients_.v_over_z.at(span.first, span.y);
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
        divisions_saved_ += std::ssize(blocks_) + (steps != 0);
        *out++ = moved(*above, down, v_16, steps == 0 ? 0 : steps_by_division({0, v_16}, {0, to_16}, steps).v_16);
        return out;
    }

    /// How many fewer divisions than for spans that are cut.
    std::int64_t divisions_saved() const { return divisions_saved_; }

  private:
    using FittingDepth = Depth<Reciprocal, PerspectiveRange::Fits>;
    static constexpr std::size_t kMostEnds = 64;

    struct BlockDepth {
        std::int64_t mantissa;
        int shift;
    };

    /// Where each block begins, and where the last one ends.
    void find_depths() {
        std::size_t count = 0;
        const auto add = [&](std::int32_t column) {
            const FittingDepth depth(gradients_.inverse_z.at(column, span_.y), reciprocal_);
            item(depths_, count++) = {depth.mantissa, depth.shift};
        };
        std::int32_t column = span_.first;
        for (const TexelBlock& block : blocks_) {
            add(column);
            column += block.count;
        }
        add(column - 1);
        knows_depths_ = true;
        divisions_saved_ -= static_cast<std::int64_t>(count);
    }

    [[gnu::always_inline]] std::uint32_t v_at(TexelOverZ v_over_z, const BlockDepth& known) const {
        FittingDepth depth;
        depth.mantissa = known.mantissa;
        depth.shift = known.shift;
        return texel_within(depth.times(v_over_z), limits_.least, limits_.greatest_v);
    }

    [[gnu::always_inline]] static TexelBlock moved(const TexelBlock& block, std::uint32_t pixels, std::uint32_t v_16,
                                                   std::int32_t v_step_16) {
        return {block.pixel + pixels, block.count, block.u_16, v_16, block.u_step_16, v_step_16};
    }

    const TextureGradients& gradients_;
    const TexelLimits& limits_;
    [[no_unique_address]] const Reciprocal reciprocal_;
    Span span_{0, 0, 0};  ///< empty: no span is like it
    std::span<const TexelBlock> blocks_;
    bool knows_depths_ = false;
    std::int64_t divisions_saved_ = 0;
    std::array<BlockDepth, kMostEnds + 1> depths_;  ///< where knows_depths_
};

}  // namespace oblong
