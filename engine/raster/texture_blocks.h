#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/raster/block_rule.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/screen/gradients.h"
#include "engine/screen/screen.h"

namespace oblong {

/// 1/z is clamped to these: the largest is that of z = 2^-15 unit, the smallest that of a point beyond any world.
inline constexpr auto kGreatestInverseZ = InverseZ::from_raw(std::int64_t{1} << 59);
inline constexpr auto kLeastInverseZ = InverseZ::from_raw(std::int64_t{1} << 24);

/// A texture coordinate pair, texels, 16.16.
struct TexelPosition {
    std::uint32_t u_16, v_16;
};

/// The range of a surface's texture coordinates for samples: inset from its edges by the most that rounding adds up to
/// in one block.
struct TexelLimits {
    Texel least, greatest_u, greatest_v;
};

/// The limits of a surface of this size, 1 to 65,535 texels, for blocks of up to `longest_px` pixels.
TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px);

/// Blocks waiting to be drawn: a batch of spans is first cut into blocks and then drawn, so that each loop keeps its
/// values in registers.
class BlockList {
  public:
    /// For spans of up to `longest_px` pixels.
    explicit BlockList(std::int32_t longest_px) : blocks_(static_cast<std::size_t>(longest_px) + kBatch) {}

    /// Whether a span of `count` pixels fits in the worst case.
    bool has_room_for(std::int32_t count) const { return used_ + static_cast<std::size_t>(count) <= blocks_.size(); }
    std::span<const TexelBlock> waiting() const { return std::span(blocks_).first(used_); }
    void clear() { used_ = 0; }

    TexelBlock* end() { return blocks_.data() + used_; }
    void set_end(const TexelBlock* end) { used_ = static_cast<std::size_t>(end - blocks_.data()); }

  private:
    static constexpr std::size_t kBatch = 2048;

    std::vector<TexelBlock> blocks_;
    std::size_t used_ = 0;
};

/// Appends the blocks of one span, for which there must be room. `pitch` is the framebuffer's. Returns how many
/// divisions that took.
using BlockCutter = std::int32_t (*)(const Span& span, std::int32_t pitch, const TextureGradients& gradients,
                                     const BlockRule& rule, const BlockThresholds& thresholds,
                                     const TexelLimits& limits, BlockList& blocks);

/// The cutter for these settings, chosen once a frame.
BlockCutter block_cutter(const Accuracy& accuracy);

/// The exact texel at the centre of a pixel.
TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row);

}  // namespace oblong
