#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/block_rule.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// The range of a surface's texture coordinates, inset from its edges by the largest rounding error of one block.
struct TexelLimits {
    Texel least, greatest_u, greatest_v;
};

/// The limits of a surface of this size, 1 to 65,535 texels, for blocks of up to `longest_px` pixels.
TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px);

/// Blocks to be drawn: a batch of spans is first cut into blocks, then drawn, so that each loop keeps its values in
/// registers.
class BlockList {
  public:
    /// For spans of up to `longest_px` pixels.
    explicit BlockList(std::int32_t longest_px) : blocks_(as_size(longest_px) + kBatch) {}

    /// The last place where a span's blocks may begin; from there on those of the longest span fit.
    const TexelBlock* last_start() const { return blocks_.data() + kBatch; }
    std::span<const TexelBlock> waiting() const { return std::span(blocks_).first(used_); }
    void clear() { used_ = 0, extra_divisions_ = 0; }
    /// Divisions in addition to those counted by divisions_of(): for blocks that were tried (BoundedTexels). Negative:
    /// divisions saved by RowRepeater.
    std::int64_t extra_divisions() const { return extra_divisions_; }
    void add_divisions(std::int64_t count) { extra_divisions_ += count; }

    TexelBlock* end() { return blocks_.data() + used_; }
    void set_end(const TexelBlock* end) { used_ = as_size(end - blocks_.data()); }

  private:
#ifdef OBLONG_SMALL_MEMORY
    static constexpr std::size_t kBatch = 512;
#else
    static constexpr std::size_t kBatch = 2048;
#endif

    std::vector<TexelBlock> blocks_;
    std::size_t used_ = 0;
    std::int64_t extra_divisions_ = 0;
};

/// How to cut the spans of one surface.
struct BlockCutting {
    TextureGradients gradients;
    TexelLimits limits{};
    BlockThresholds thresholds{};      ///< for Bounded
    std::int32_t texel_bound_256 = 0;  ///< for BoundedTexels: BlockRule's
    bool fits_range = false;           ///< fits_range() of the spans: nothing is clamped before multiplication
    bool takes_whole_spans = false;    ///< every span is one block: affine, or within the bound
};

/// The cutter for these dials, chosen once a frame.
BlockCutter block_cutter(const Accuracy& accuracy, const Kernels& kernels = best_kernels());

/// The number of divisions for cutting these spans into these blocks: one where a span begins, and one at each end of a
/// block, tried ends included; none for a last block of one pixel, if 1/z is constant along rows, or if the row repeats
/// one before.
std::int64_t divisions_of(std::span<const Span> spans, const BlockCutting& cutting, const BlockList& blocks);

/// The exact texel at the centre of a pixel.
TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row);

// In perspective_range.cpp.

/// 1/z is clamped to these: z from 2^-15 unit to beyond any world.
inline constexpr auto kGreatestInverseZ = InverseZ::from_raw(std::int64_t{1} << 59);
inline constexpr auto kLeastInverseZ = InverseZ::from_raw(std::int64_t{1} << 24);
/// The least 1/z of a range that fits, of z below 65,536 units: Depth shifts it by less than 32.
inline constexpr auto kLeastFittingInverseZ = InverseZ::from_raw(std::int64_t{1} << 28);

/// Whether 1/z is from kLeastFittingInverseZ to kGreatestInverseZ and |u|, |v| are below 114,000 texels at every pixel
/// of a rectangle around a polygon's spans: then cutters give the same results without clamping. The quantities are
/// linear, so their extremes are at the corners.
bool fits_range(const TextureGradients& gradients, const ScreenRectangle& rectangle);

/// The least 1/z in the rectangle.
InverseZ least_inverse_z(const LinearQuantity<InverseZ>& inverse_z, const ScreenRectangle& rectangle);

}  // namespace oblong
