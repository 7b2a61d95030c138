#include "engine/raster/block_rule.h"

#include <algorithm>
#include <bit>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/wide.h"

namespace oblong {

BlockRule make_block_rule(const Accuracy& accuracy) {
    BlockRule rule;
    rule.pixel_bound_256 = accuracy.pixel_bound_256;
    rule.texel_bound_256 = accuracy.texel_bound_256;
    const std::int64_t error_4096 = accuracy.pixel_bound_256 * std::int64_t{15};  // E: 15/16 of the bound
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        // n - E; a block no longer than E is always within the bound.
        const std::int64_t beyond_4096 = std::max((std::int64_t{4096} << k) - error_4096, std::int64_t{0});
        // (n - E)^2 has 24 fraction bits, and E has 12; divided by 16 more, the quotient has 8.
        const std::int64_t divisor = 4 * 16 * error_4096;
        rule.factor_8[k] = static_cast<std::uint64_t>((beyond_4096 * beyond_4096 + divisor - 1) / divisor);
        rule.step_end[k] = std::uint64_t{1} << (61 - std::bit_width(rule.factor_8[k]));
    }
    return rule;
}

InverseZ block_threshold(const BlockRule& rule, InverseZ inverse_z_step, int log2) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 61;
    const std::uint64_t step = std::min(magnitude(inverse_z_step), std::uint64_t{1} << 50);
    const std::uint64_t fall = inverse_z_step < InverseZ{} ? step : 0;
    const std::uint64_t product = ((step * item(rule.factor_8, log2)) >> 8) + 1;
    const std::uint64_t least = (step < item(rule.step_end, log2) ? product : kMost) + (fall << log2);
    note_range<"block thresholds">(InverseZ::from_raw(static_cast<std::int64_t>(least)));
    return InverseZ::from_raw(static_cast<std::int64_t>(std::min(least, kMost)));
}

BlockThresholds make_block_thresholds(const BlockRule& rule, InverseZ inverse_z_step, int longest_log2) {
    BlockThresholds thresholds;
    thresholds.least_inverse_z.fill(InverseZ::highest());
    thresholds.least_inverse_z.front() = InverseZ::lowest();
    for (int k = 1; k <= longest_log2; ++k)
        item(thresholds.least_inverse_z, k) = block_threshold(rule, inverse_z_step, k);
    return thresholds;
}

int longest_block_log2(const BlockRule& rule, Fixed<std::int64_t, 16> texels_per_pixel) {
    // A sixteenth of the bound in steps of 2^-16 texel. Each pixel may lose one step, and rounding the ends and z 8
    // more.
    const std::int64_t steps =
        floor_of<4>(std::min(texels_per_pixel, Fixed<std::int64_t, 16>::from_int(65536)) * rule.pixel_bound_256);
    const auto pixels = static_cast<std::uint64_t>(std::max(steps - 8, std::int64_t{1}));
    return std::min(static_cast<int>(std::bit_width(pixels)) - 1, kBlockSizes - 1);
}

}  // namespace oblong
