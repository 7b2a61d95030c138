#include "engine/raster/block_rule.h"

#include <algorithm>
#include <bit>

#include "engine/base/range_probe.h"

namespace oblong {

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

BlockThresholds make_block_thresholds(const BlockRule& rule, std::int64_t inverse_z_step_44) {
    BlockThresholds thresholds;
    const std::uint64_t size = inverse_z_step_44 < 0 ? 0 - static_cast<std::uint64_t>(inverse_z_step_44)
                                                     : static_cast<std::uint64_t>(inverse_z_step_44);
    const std::uint64_t capped = std::min(size, std::uint64_t{1} << 50);
    for (std::size_t k = 0; k < kBlockSizes; ++k) {
        const auto factor = static_cast<std::uint64_t>(rule.factor_8[k]);
        const auto bits = std::bit_width(capped) + std::bit_width(factor);
        std::uint64_t least = bits > 61 ? std::uint64_t{1} << 61 : ((capped * factor) >> 8) + 1;
        if (inverse_z_step_44 < 0) least += capped << k;
        note_range<Quantity::ThresholdProduct>(static_cast<std::int64_t>(least));
        thresholds.least_inverse_z_44[k] = static_cast<std::int64_t>(std::min(least, std::uint64_t{1} << 61));
    }
    return thresholds;
}

}  // namespace oblong
