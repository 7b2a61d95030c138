#include "engine/raster/block_rule.h"

#include <algorithm>
#include <bit>

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"

namespace oblong {

BlockRule make_block_rule(const Accuracy& accuracy) {
    BlockRule rule;
    rule.texturing = accuracy.texturing;
    rule.texel_bound_256 = accuracy.texel_bound_256;
    const std::int64_t error = accuracy.pixel_bound_256;
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        // A block no longer than the error allowed is within it whatever its slope.
        const std::int64_t reach = std::max((std::int64_t{256} << k) - error, std::int64_t{0});
        rule.factor_8[k] = static_cast<std::uint64_t>((reach * reach + 4 * error - 1) / (4 * error));
    }
    return rule;
}

BlockThresholds make_block_thresholds(const BlockRule& rule, InverseZ inverse_z_step) {
    BlockThresholds thresholds;
    const bool falls = inverse_z_step < InverseZ{};
    const std::uint64_t capped = std::min(detail::magnitude(inverse_z_step.raw), std::uint64_t{1} << 50);
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        const auto bits = std::bit_width(capped) + std::bit_width(rule.factor_8[k]);
        std::uint64_t least = bits > 61 ? std::uint64_t{1} << 61 : ((capped * rule.factor_8[k]) >> 8) + 1;
        if (falls) least += capped << k;
        note_range<"block thresholds">(InverseZ::from_raw(static_cast<std::int64_t>(least)));
        thresholds.least_inverse_z[k] =
            InverseZ::from_raw(static_cast<std::int64_t>(std::min(least, std::uint64_t{1} << 61)));
    }
    return thresholds;
}

}  // namespace oblong
