#include "engine/effects/fog.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

namespace {

/// Depth times density over 64 where level k begins, k = 1 to 63: sqrt(-ln(1 - (k - 1/2) / 63)), with 28 fraction bits.
using FogReach = Fixed<std::int64_t, 28>;
constexpr std::array<std::int32_t, FogTable::kLevels - 1> kReach_28 = {
    23961785,  41670272,  54015832,  64177081,  73075592,  81132270,  88581296,  95568943,  102193919,
    108526656, 114619600, 120513146, 126239287, 131823964, 137288644, 142651414, 147927766, 153131170,
    158273501, 163365370, 168416382, 173435336, 178430393, 183409211, 188379061, 193346923, 198319575,
    203303670, 208305810, 213332615, 218390785, 223487177, 228628866, 233823225, 239078003, 244401413,
    249802233, 255289920, 260874742, 266567938, 272381897, 278330392, 284428849, 290694686, 297147743,
    303810815, 310710341, 317877307, 325348432, 333167771, 341388914, 350078090, 359318628, 369217618,
    379916177, 391605996, 404557485, 419170937, 436078114, 456369625, 482201840, 518967706, 590331126};

constexpr InverseZ kNowhere = InverseZ::lowest();

/// The greatest depth whose rounded 1/z is above another: floor(2^60 / depth + 1/2) > other
/// is 2^61 >= (2 other + 1) depth, in steps.
View greatest_depth_above(InverseZ other) {
    constexpr int kBits = InverseZ::kFractionBits + View::kFractionBits + 1;
    return View::from_raw((std::int64_t{1} << kBits) / (2 * other.raw + 1));
}

InverseZ clamped(InverseZ inverse_z) {
    return std::clamp(inverse_z, InverseZ{}, kGreatestInverseZ);
}

/// How many columns, from one with this 1/z and level on, have the same level; may exceed `most`. `step` is not 0.
std::int64_t columns_of_level(InverseZ inverse_z, InverseZ step, std::int32_t level, const FogDepths& depths,
                              std::int64_t most) {
    const auto& greatest = depths.greatest_inverse_z;
    if (step > InverseZ{}) return level == 0 ? most : (item(greatest, level) - inverse_z) / step + 1;
    if (level + 1 == FogTable::kLevels || item(greatest, level + 1) == kNowhere) return most;
    const InverseZ fall = -std::max(step, -kGreatestInverseZ);
    return (inverse_z - item(greatest, level + 1) - InverseZ::ulp()) / fall + 1;
}

}  // namespace

std::int32_t FogDepths::level_at(InverseZ inverse_z) const {
    // The last entry not below it, by bisection.
    std::int32_t level = 0;
    for (std::int32_t half = FogTable::kLevels / 2; half > 0; half /= 2)
        if (inverse_z <= item(greatest_inverse_z, level + half)) level += half;
    return level;
}

FogDepths make_fog_depths(FogDensity density, View start, View end) {
    FogDepths depths;
    depths.greatest_inverse_z.fill(kNowhere);
    depths.greatest_inverse_z[0] = InverseZ::highest();
    depths.greatest_before.fill(View::highest());
    depths.greatest_before[0] = View::lowest();
    if (density <= FogDensity{}) return depths;
    for (std::int32_t level = 1; level < FogTable::kLevels; ++level) {
        const View reach = divide<View>(FogReach::from_raw(item(kReach_28, level - 1)) * 64, density);
        const View z = saturating_sum(std::max(start, View{}), reach);
        if (z > end || z == View::highest()) break;
        const InverseZ greatest = reciprocal<InverseZ>(z);
        item(depths.greatest_inverse_z, level) = greatest;
        item(depths.greatest_before, level) = greatest_depth_above(greatest);
    }
    return depths;
}

void append_fog_run(const FogRun& run, std::vector<FogRun>& runs) {
    if (!runs.empty() && runs.back().level == run.level && runs.back().y == run.y && runs.back().end == run.first)
        runs.back().end = run.end;
    else
        runs.push_back(run);
}

void append_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const FogDepths& depths,
                     std::vector<FogRun>& runs) {
    for (std::int32_t column = span.first; column < span.end;) {
        const InverseZ here = clamped(inverse_z.at(column, span.y)), step = inverse_z.per_column;
        const std::int32_t level = depths.level_at(here), left = span.end - column;
        const std::int64_t count = step == InverseZ{} ? left : columns_of_level(here, step, level, depths, left);
        const auto end = static_cast<std::int32_t>(column + std::min<std::int64_t>(count, left));
        append_fog_run({{span.y, column, end}, level}, runs);
        column = end;
    }
}

void draw_fog(std::span<const FogRun> runs, const FogTable& table, Framebuffer out) {
    for (const FogRun& run : runs) {
        if (run.level == 0) continue;
        const ColourRow& row = item(table.levels, run.level);
        std::uint8_t* const end = out.row(run.y) + run.end;
        for (std::uint8_t* pixel = out.row(run.y) + run.first; pixel != end; ++pixel) *pixel = row[*pixel];
    }
}

}  // namespace oblong
