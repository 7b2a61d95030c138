#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/support/random.h"

namespace oblong::test {

/// Directions of every kind: each component any number of 30 bits, now and then short or zero.
inline Vec3<Unit> any_direction(std::mt19937& random) {
    const auto any = [&random] {
        const auto bits = static_cast<std::int32_t>(random()) / 2;
        return Unit::from_raw(floor_shift(bits, static_cast<int>(random() % 40) / 10 * 8));
    };
    return {any(), any(), any()};
}

inline constexpr Vec3<Unit> kX{Unit::from_int(1), {}, {}}, kY{{}, Unit::from_int(1), {}}, kZ{{}, {}, Unit::from_int(1)};

/// The largest |r_i . r_j - d_ij| of a basis, in steps of 2^-60.
inline std::int64_t worst_flaw_60(const Basis& basis) {
    const std::array axes{basis.right, basis.up, basis.forward};
    std::int64_t worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) {
            const std::int64_t should_be = i == j ? std::int64_t{1} << 60 : 0;
            worst = std::max(worst, std::abs(dot(axes[i], axes[j]).raw - should_be));
        }
    return worst;
}
/// 2^-26, the bound that every basis keeps, in steps of 2^-60.
inline constexpr std::int64_t kOrthonormal60 = std::int64_t{1} << 34;

}  // namespace oblong::test
