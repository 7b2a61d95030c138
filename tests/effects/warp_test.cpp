// The warp of liquids against Quake's formula in doubles.
#include "engine/effects/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace oblong::test {

TEST(Warp, IsQuakesWaveAtEachMipLevel) {
    for (const std::int64_t time_ms : {std::int64_t{0}, std::int64_t{1}, std::int64_t{999}, std::int64_t{3'200},
                                       std::int64_t{6'399}, (std::int64_t{1} << 40) + 50}) {
        const WarpTables tables = make_warp_tables(time_ms);
        for (std::size_t mip = 0; mip < 4; ++mip)
            for (std::size_t i = 0; i < WarpTable::kEntries; ++i) {
                const double scale = std::ldexp(1.0, static_cast<int>(mip));
                const double turns = (static_cast<double>(i) * scale + static_cast<double>(time_ms % 6'400) / 50) / 128;
                const double texels = 8 * (1 + std::sin(2 * std::numbers::pi * turns)) / scale;
                // Within a step of the angle, 8 * 2 pi / 65536 texels, and one of the table.
                ASSERT_NEAR(tables[mip].shift_16[i] / 65536.0, texels, 0.0008) << time_ms << ", " << mip << ", " << i;
            }
    }
}

TEST(Warp, NeverMovesATexelBeyondItsRange) {
    for (std::int64_t time_ms = 0; time_ms < kWarpPeriod_ms; time_ms += 7) {
        const WarpTables tables = make_warp_tables(time_ms);
        for (std::size_t mip = 0; mip < 4; ++mip)
            for (const std::uint32_t shift_16 : tables[mip].shift_16) ASSERT_LE(shift_16, 16u * 65536 >> mip);
    }
}

}  // namespace oblong::test
