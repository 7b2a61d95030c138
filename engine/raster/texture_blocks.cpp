#include "engine/raster/texture_blocks.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

/// 1/z, u/z, v/z at one place.
struct Perspective {
    std::int64_t inverse_z_44, u_over_z_30, v_over_z_30;

    Perspective(const TextureGradients& gradients, std::int32_t column, std::int32_t row)
        : inverse_z_44(gradients.inverse_z_44.at(column, row)),
          u_over_z_30(gradients.u_over_z_30.at(column, row)),
          v_over_z_30(gradients.v_over_z_30.at(column, row)) {}
};

/// The largest 1/z that Depth takes: z = 2^-15, nearer than the near plane. The smallest: beyond any world.
constexpr std::int64_t kGreatestInverseZ_44 = std::int64_t{1} << 59, kLeastInverseZ_44 = std::int64_t{1} << 24;

/// z as a reciprocal of 33 bits and a scale: one 64-bit division. Relative error below 2^-26.
struct Depth {
    std::int64_t mantissa;  ///< 2^60 / (the leading 28 bits of 1/z), in (2^32, 2^33]
    int shift;              ///< what brings 1/z to 60 bits

    explicit Depth(std::int64_t inverse_z_44) {
        const auto positive =
            static_cast<std::uint64_t>(std::clamp(inverse_z_44, kLeastInverseZ_44, kGreatestInverseZ_44));
        shift = std::countl_zero(positive) - 4;
        mantissa = static_cast<std::int64_t>((std::uint64_t{1} << 60) / ((positive << shift) >> 32));
    }

    /// (u/z) * z, 16.16, from 0 to 65,535 texels: what is outside comes to the nearer end, so that nothing overflows.
    std::int64_t texel_16(std::int64_t over_z_30, std::int64_t inverse_z_44) const {
        const std::int64_t greatest = std::min(inverse_z_44, kGreatestInverseZ_44) * 4 - 4;
        const std::int64_t within = std::clamp(over_z_30, std::int64_t{0}, std::max(greatest, std::int64_t{0}));
        return floor_shift(floor_shift(within << shift, 32) * mantissa, 30);
    }
};

TexelPosition texel_of(const Perspective& at, const Depth& depth, const TexelLimits& limits) {
    const std::int64_t u_16 = depth.texel_16(at.u_over_z_30, at.inverse_z_44);
    const std::int64_t v_16 = depth.texel_16(at.v_over_z_30, at.inverse_z_44);
    return {static_cast<std::uint32_t>(std::clamp(u_16, limits.least_16, limits.greatest_u_16)),
            static_cast<std::uint32_t>(std::clamp(v_16, limits.least_16, limits.greatest_v_16))};
}

std::int32_t step_by_shift(std::uint32_t from, std::uint32_t to, int log2) {
    return static_cast<std::int32_t>(floor_shift(std::int64_t{to} - from, log2));
}

std::int32_t step_by_division(std::uint32_t from, std::uint32_t to, std::int32_t count) {
    const std::int64_t whole = std::int64_t{to} - from;
    return static_cast<std::int32_t>(whole / count - (whole % count < 0));
}

/// Cuts one span into blocks, left to right. Each block ends where the next begins, so a division serves twice.
class SpanCutter {
  public:
    SpanCutter(const Span& span, std::int32_t pitch, const TextureGradients& gradients, const TexelLimits& limits,
               std::vector<TexelBlock>& blocks)
        : span_(span),
          gradients_(gradients),
          limits_(limits),
          blocks_(blocks),
          column_(span.first),
          pixel_(static_cast<std::uint32_t>(span.y * pitch + span.first)),
          here_(gradients, span.first, span.y),
          depth_(here_.inverse_z_44),
          texel_(texel_of(here_, depth_, limits)) {}

    std::int32_t left() const { return span_.end - column_; }
    std::int64_t inverse_z_44() const { return here_.inverse_z_44; }
    std::int32_t divisions() const { return divisions_; }

    /// A block of 2^log2 pixels, all of them in the span.
    void cut_power(int log2) {
        const TexelPosition from = texel_;
        advance(1 << log2);
        append(from, 1 << log2, step_by_shift(from.u_16, texel_.u_16, log2),
               step_by_shift(from.v_16, texel_.v_16, log2));
    }

    /// The last block, of whatever is left (1 or more).
    void cut_rest() {
        const std::int32_t count = left();
        if (count == 1) return append(texel_, 1, 0, 0);
        const TexelPosition from = texel_;
        advance(count);
        append(from, count, step_by_division(from.u_16, texel_.u_16, count),
               step_by_division(from.v_16, texel_.v_16, count));
    }

  private:
    void advance(std::int32_t count) {
        column_ += count;
        const std::int64_t before = here_.inverse_z_44;
        here_ = Perspective(gradients_, column_, span_.y);
        if (here_.inverse_z_44 != before) {
            depth_ = Depth(here_.inverse_z_44);
            ++divisions_;
        }
        texel_ = texel_of(here_, depth_, limits_);
    }

    void append(TexelPosition from, std::int32_t count, std::int32_t u_step_16, std::int32_t v_step_16) {
        blocks_.push_back({pixel_, count, from.u_16, from.v_16, u_step_16, v_step_16});
        pixel_ += static_cast<std::uint32_t>(count);
    }

    const Span& span_;
    const TextureGradients& gradients_;
    const TexelLimits& limits_;
    std::vector<TexelBlock>& blocks_;
    std::int32_t column_;
    std::uint32_t pixel_;
    Perspective here_;
    Depth depth_;
    TexelPosition texel_;
    std::int32_t divisions_ = 1;
};

void cut_every(SpanCutter& cutter, int log2) {
    while (cutter.left() > 1 << log2) cutter.cut_power(log2);
    cutter.cut_rest();
}

void cut_bounded(SpanCutter& cutter, const BlockLadder& ladder) {
    int log2 = kBlockSizes - 1;
    const auto& least = ladder.least_inverse_z_44;
    while (true) {
        while (log2 > 0 && cutter.inverse_z_44() < least[static_cast<std::size_t>(log2)]) --log2;
        if (cutter.left() <= 1 << log2) return cutter.cut_rest();
        cutter.cut_power(log2);
        while (log2 + 1 < kBlockSizes && cutter.inverse_z_44() >= least[static_cast<std::size_t>(log2) + 1]) ++log2;
    }
}

}  // namespace

BlockRule make_block_rule(const Accuracy& accuracy) {
    BlockRule rule;
    rule.texturing = accuracy.texturing;
    const std::int64_t error = accuracy.texture_error_px_256;
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        // A block no longer than the error allowed is within it whatever its slope.
        const std::int64_t reach = std::max((std::int64_t{256} << k) - error, std::int64_t{0});
        rule.factor_8[k] = (reach * reach + 4 * error - 1) / (4 * error);
    }
    return rule;
}

BlockLadder make_block_ladder(const BlockRule& rule, std::int64_t inverse_z_step_44) {
    BlockLadder ladder;
    const std::uint64_t size = inverse_z_step_44 < 0 ? 0 - static_cast<std::uint64_t>(inverse_z_step_44)
                                                     : static_cast<std::uint64_t>(inverse_z_step_44);
    const std::uint64_t capped = std::min(size, std::uint64_t{1} << 50);
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        const auto factor = static_cast<std::uint64_t>(rule.factor_8[k]);
        const auto bits = std::bit_width(capped) + std::bit_width(factor);
        std::uint64_t least = bits > 61 ? std::uint64_t{1} << 61 : ((capped * factor) >> 8) + 1;
        if (inverse_z_step_44 < 0) least += capped << k;
        ladder.least_inverse_z_44[k] = static_cast<std::int64_t>(std::min(least, std::uint64_t{1} << 61));
    }
    return ladder;
}

TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px) {
    // Flooring a step loses less than a unit of 2^-16 a pixel: from this inset no sample drifts below 0.
    return {longest_px, (std::int64_t{width} << 16) - 1, (std::int64_t{height} << 16) - 1};
}

TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row) {
    const Perspective at(gradients, column, row);
    return texel_of(at, Depth(at.inverse_z_44), limits);
}

std::int32_t append_blocks(const Span& span, std::int32_t pitch, const TextureGradients& gradients,
                           const BlockRule& rule, const BlockLadder& ladder, const TexelLimits& limits,
                           std::vector<TexelBlock>& blocks) {
    SpanCutter cutter(span, pitch, gradients, limits, blocks);
    switch (rule.texturing) {
        case Texturing::Affine:
            cutter.cut_rest();
            break;
        case Texturing::Every16:
            cut_every(cutter, 4);
            break;
        case Texturing::Bounded:
            cut_bounded(cutter, ladder);
            break;
        case Texturing::Exact:
            cut_every(cutter, 0);
            break;
    }
    return cutter.divisions();
}

}  // namespace oblong
