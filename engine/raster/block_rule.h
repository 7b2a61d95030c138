#pragma once

#include <array>
#include <cstdint>

#include "engine/accuracy/accuracy.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// Blocks are 1, 2, 4 ... 512 pixels long.
inline constexpr int kBlockSizes = 10;

/// The dials for block lengths, computed once a frame.
struct BlockRule {
    std::int32_t pixel_bound_256 = 0;  ///< Bounded: the largest error on the screen, 1/256 pixel
    std::int32_t texel_bound_256 = 0;  ///< BoundedTexels: the largest error of u and v, 1/256 texel
    /// Bounded: a block of n = 2^k pixels has an error below E pixels, 15/16 of the bound, if 1/z >= |its step| * (n -
    /// E)^2 / 4 E. This is the factor of the step, rounded up, with 8 fraction bits.
    std::array<std::uint64_t, kBlockSizes> factor_8{};
    std::array<std::uint64_t, kBlockSizes> step_end{};  ///< from this step on the product might overflow
};

BlockRule make_block_rule(const Accuracy& accuracy);

/// The least 1/z at which a block of 2^k pixels may begin, for one surface: factor times step. If 1/z falls along the
/// row, its decrease over the block is added, since the bound holds for the smaller end.
///
/// A sixteenth of the bound is left for rounding: texels of 16.16, and steps that lose up to 2^-16 texel a pixel. On a
/// surface so near that a texel is many pixels wide, this limits a block's length: `longest_log2`.
///
/// Proof of the bound: along a row w = 1/z is linear and u = (u/z)/w a Moebius function. An affine block from x = 0 to
/// n shows at x the texel that belongs at x', with x' - x = b x (x - n) / (w1 - b x), w1 = w at n, b the step. For b >
/// 0 the error is below E if b (n - x)(x - E) <= E w0 for all x; the left side is largest at x = (n + E)/2, so b (n -
/// E)^2 <= 4 E w0 is enough. For b < 0 the same holds from the other end.
struct BlockThresholds {
    /// Every 1/z reaches the first, none the last.
    std::array<InverseZ, kBlockSizes + 1> least_inverse_z{};
};

/// The threshold for 2^log2 pixels; log2 is 1 to kBlockSizes - 1.
InverseZ block_threshold(const BlockRule& rule, InverseZ inverse_z_step, int log2);

/// The thresholds of a surface whose 1/z changes by `inverse_z_step` per column, for blocks of up to 2^longest_log2
/// pixels; longest_log2 is 0 to kBlockSizes - 1.
BlockThresholds make_block_thresholds(const BlockRule& rule, InverseZ inverse_z_step,
                                      int longest_log2 = kBlockSizes - 1);

/// The longest blocks whose rounding stays below a sixteenth of the bound, on a surface whose nearest pixel is at least
/// this many texels wide.
int longest_block_log2(const BlockRule& rule, Fixed<std::int64_t, 16> texels_per_pixel);

}  // namespace oblong
