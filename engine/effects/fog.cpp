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

/// How many columns, from one with this 1/z and level on, have the same level; may exceed `most`. `step` is not 0.
std::int64_t columns_of_level(InverseZ inverse_z, InverseZ step, std::int32_t level, const FogDepths& depths,
                              std::int64_t most) {
    const auto& greatest = depths.greatest_inverse_z;
    if (step > InverseZ{}) return level == 0 ? most : (item(greatest, level) - inverse_z) / step + 1;
    if (level + 1 == FogTable::kLevels || item(greatest, level + 1) == kNowhere) return most;
    const InverseZ fall = -std::max(step, -kGreatestInverseZ);
    return (inverse_z - item(greatest, level + 1) - InverseZ::ulp()) / fall + 1;
}

constexpr std::int32_t kStep_px = 16;
constexpr InverseZ kNearest = InverseZ::from_int(1);
constexpr View kHighestClimb = View::from_int(std::int64_t{1} << 24);

using Density = Fixed<std::int64_t, InverseZ::kFractionBits + View::kFractionBits>;  ///< 0 to 1

/// The integral of the density from the top down to `depth` below it.
View density_above(View depth, View fade_depth, InverseZ half_inverse_fade) {
    if (depth <= View{}) return {};
    if (depth >= fade_depth) return depth - floor_shift(fade_depth, 1);
    return product<View>(depth, product<Density>(depth, half_inverse_fade));
}

/// The depth in full fog that is equivalent to a ray from the eye to depth z.
View length_in_fog(View z, View climb, const HeightFogView& view) {
    const View begin = view.top_above_eye, end = begin - climb, fade_depth = view.fade_depth;
    const auto [least, most] = std::minmax(begin, end);
    if (least >= fade_depth) return z;
    if (most <= View{}) return {};
    const bool is_linear = least >= View{} && most <= fade_depth;  // then the mean density is that of the middle
    if (is_linear) return product<View>(z, product<Density>(begin + end, view.half_inverse_fade));
    const View density = view.density_above_eye - density_above(end, fade_depth, view.half_inverse_fade);
    return product_over<View>(z, density, climb);
}

/// Finds the levels of a span's pixels.
class LevelFinder {
  public:
    LevelFinder(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                const FogDepths& depths, std::vector<FogRun>& runs)
        : row_(span.y), inverse_z_(inverse_z), view_(view), depths_(depths), runs_(runs) {}

    /// `guess`: a level nearby.
    std::int32_t level_at(std::int32_t column, std::int32_t guess) const {
        const auto z = reciprocal<View>(std::clamp(inverse_z_.at(column, row_), kLeastInverseZ, kGreatestInverseZ));
        const auto climb = std::clamp(product<View>(z, view_.rise.at(column, row_)), -kHighestClimb, kHighestClimb);
        return depths_.level_at(std::max(length_in_fog(z, climb, view_), View{}), guess);
    }

    /// Appends pixels [first, end), given the levels of pixels `first` and `end`.
    void append(std::int32_t first, std::int32_t end, std::int32_t first_level, std::int32_t end_level) {
        if (first_level == end_level || end - first == 1)
            return append_fog_run({{row_, first, end}, first_level}, runs_);
        const std::int32_t middle = (first + end) / 2, level = level_at(middle, first_level);
        append(first, middle, first_level, level);
        append(middle, end, level, end_level);
    }

  private:
    const std::int32_t row_;
    const LinearQuantity<InverseZ>& inverse_z_;
    const HeightFogView& view_;
    const FogDepths& depths_;
    std::vector<FogRun>& runs_;
};

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

std::int64_t pixels_of(std::span<const FogRun> runs) {
    std::int64_t pixels = 0;
    for (const FogRun& run : runs) pixels += run.end - run.first;
    return pixels;
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
        const InverseZ here = std::clamp(inverse_z.at(column, span.y), InverseZ{}, kGreatestInverseZ);
        const InverseZ step = inverse_z.per_column;
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

HeightFogView make_height_fog_view(const HeightFog& fog, const Vec3<World>& eye, const ViewDirections& directions) {
    const View depth = convert<View>(widening_difference(fog.top, eye.z));
    const View fade_depth = std::max(convert<View>(fog.fade_depth), View{});
    const auto half_inverse_fade = reciprocal<InverseZ>(fade_depth * 2);
    return {depth, fade_depth, half_inverse_fade, density_above(depth, fade_depth, half_inverse_fade), directions.z};
}

/// A point is above the top if z rise >= top_above_eye; divided by z, this is linear on the screen. The top is taken a
/// unit higher, which exceeds rounding errors, and depths below one unit count as one.
bool is_clear(std::int32_t column, std::int32_t row, InverseZ inverse_z, const HeightFogView& view) {
    const std::int64_t height = floor_of(-view.top_above_eye) - 1;
    if (height < 0 || inverse_z < InverseZ{}) return false;
    const auto steepest = convert<DirectionPart>(std::min(inverse_z, kNearest), Rounding::Floor) * height;
    return view.rise.at(column, row) + steepest >= DirectionPart{};
}

bool is_clear(const ScreenRectangle& pixels, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view) {
    const auto is_corner_clear = [&](std::int32_t column, std::int32_t row) {
        return is_clear(column, row, inverse_z.at(column, row), view);
    };
    const std::int32_t last_column = pixels.end_column - 1, last_row = pixels.end_row - 1;
    return is_within(inverse_z.per_column, kNearest) && is_within(inverse_z.per_row, kNearest) &&
           is_corner_clear(pixels.first_column, pixels.first_row) && is_corner_clear(last_column, pixels.first_row) &&
           is_corner_clear(pixels.first_column, last_row) && is_corner_clear(last_column, last_row);
}

void append_height_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                            const FogDepths& depths, std::vector<FogRun>& runs) {
    if (is_clear({span.first, span.end, span.y, span.y + 1}, inverse_z, view)) return append_fog_run({span, 0}, runs);
    LevelFinder finder(span, inverse_z, view, depths, runs);
    std::int32_t first = span.first, level = finder.level_at(first, runs.empty() ? 0 : runs.back().level);
    for (const std::int32_t last = span.end - 1; first < last;) {
        const std::int32_t end = std::min(first + kStep_px, last), end_level = finder.level_at(end, level);
        finder.append(first, end, level, end_level);
        first = end;
        level = end_level;
    }
    append_fog_run({{span.y, first, span.end}, level}, runs);
}

}  // namespace oblong
