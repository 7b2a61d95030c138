#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/raster/accuracy.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/raster/span.h"
#include "engine/screen/gradients.h"

namespace oblong {

/// Blocks are 1, 2, 4 ... 512 pixels long.
inline constexpr int kBlockSizes = 10;

/// What the dials say of block lengths, worked out once a frame.
struct BlockRule {
    Texturing texturing = Texturing::Bounded;
    /// Bounded: a block of n = 2^k pixels keeps its error under E pixels where 1/z >= |its step| * (n - E)^2 / 4 E:
    /// this factor, rounded up, with 8 fraction bits.
    std::array<std::int64_t, kBlockSizes> factor_8{};
};

BlockRule make_block_rule(const Accuracy& accuracy);

/// The least 1/z at which a block of 2^k pixels may begin, for one surface: factor times step, and where 1/z falls
/// along the row, as much more as it falls on the way, since the bound holds for the smaller end.
///
/// Why it is safe: along a row w = 1/z is linear and u = (u/z)/w a Moebius function. An affine block from x = 0 to n
/// shows at x the texel that belongs at x', with x' - x = b x (x - n) / (w1 - b x), w1 = w at n, b the step. For b > 0
/// the error is below E where b (n - x)(x - E) <= E w0 for all x; the left side is largest at x = (n + E)/2, so b (n -
/// E)^2 <= 4 E w0 does. For b < 0 the same from the other end.
struct BlockLadder {
    std::array<std::int64_t, kBlockSizes> least_inverse_z_44{};
};

BlockLadder make_block_ladder(const BlockRule& rule, std::int64_t inverse_z_step_44);

/// A texture coordinate pair, texels, 16.16.
struct TexelPosition {
    std::uint32_t u_16, v_16;
};

/// Where in a surface samples may fall, texels, 16.16: inset from its edges by what rounding can drift in one block.
struct TexelLimits {
    std::int64_t least_16 = 0, greatest_u_16 = 0, greatest_v_16 = 0;
};

/// The limits of a surface of this size, 1 to 65,535 texels, for blocks of up to `longest_px` pixels.
TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px);

/// Blocks that wait to be drawn: a batch of spans is cut up first and then drawn, so that each loop keeps its
/// registers.
class BlockList {
  public:
    /// For spans of up to `longest_px` pixels.
    explicit BlockList(std::int32_t longest_px) : blocks_(static_cast<std::size_t>(longest_px) + kBatch) {}

    /// Whether a span of `count` pixels surely fits.
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
std::int32_t append_blocks(const Span& span, std::int32_t pitch, const TextureGradients& gradients,
                           const BlockRule& rule, const BlockLadder& ladder, const TexelLimits& limits,
                           BlockList& blocks);

/// The exact texel at the centre of a pixel.
TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row);

}  // namespace oblong
