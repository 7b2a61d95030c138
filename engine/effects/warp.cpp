#include "engine/effects/warp.h"

#include "engine/base/table.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

constexpr std::uint32_t kAmplitude_texels = 8;

/// amplitude (1 + sin), which is never below 0.
std::uint32_t raised_sine_16(Angle angle) {
    return static_cast<std::uint32_t>((std::int64_t{1} << 30) + floor_of<30>(sine(angle))) /
           ((1u << 14) / kAmplitude_texels);
}

}  // namespace

WarpTables make_warp_tables(std::int64_t time_ms) {
    constexpr std::uint32_t kEntries = WarpTable::kEntries;
    const std::int64_t phase = time_ms % kWarpPeriod_ms * 65536 / kWarpPeriod_ms;
    WarpTables tables;
    for (std::uint32_t i = 0; i < kEntries; ++i)
        tables[0].shift_16[i] = raised_sine_16(Angle::from_bam(phase + i * (65536 / kEntries)));
    for (int mip = 1; mip < 4; ++mip)
        for (std::uint32_t i = 0; i < kEntries; ++i)
            item(tables, mip).shift_16[i] = tables[0].shift_16[(i << mip) % kEntries] >> mip;
    return tables;
}

}  // namespace oblong
