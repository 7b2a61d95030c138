// The warp of liquids against Quake's formula in doubles.
#include "engine/effects/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace oblong::test {

TEST(Warp, IsQuakesWaveAtEachMipLevel) {
    for (const std::int64_t time_ms : {0, 1, 50, 999, 3'200, 6'399, 1'234'567}) {
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

TEST(Warp, MovesAndRepeatsAfterItsPeriod) {
    const auto entries_at = [](std::int64_t time_ms) { return make_warp_tables(time_ms)[1].shift_16; };
    const std::int64_t late_ms = (std::int64_t{1} << 40) / kWarpPeriod_ms * kWarpPeriod_ms;
    for (const std::int64_t time_ms : {0, 17, 1'600, 6'399}) {
        EXPECT_EQ(entries_at(time_ms), entries_at(time_ms + kWarpPeriod_ms));
        EXPECT_EQ(entries_at(time_ms), entries_at(time_ms + late_ms));
        EXPECT_NE(entries_at(time_ms), entries_at(time_ms + kWarpPeriod_ms / 2));
        EXPECT_NE(entries_at(time_ms), entries_at(time_ms + 10)) << "waves move evenly, not 20 times a second";
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
