#include "engine/effects/height_fog.h"

#include <algorithm>

#include "engine/fixed/arithmetic.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

namespace {

constexpr std::int32_t kStep_px = 16;
/// Rays that climb less than this have a constant density, that of their middle.
constexpr View kLevelClimb = View::from_raw(1 << 12);
constexpr InverseZ kOne = InverseZ::from_int(1);
constexpr View kHighestClimb = View::from_int(std::int64_t{1} << 24);

/// The density at `depth` below the top, 0 to 1; density_above() is its integral from the top down.
View density_at(View depth, View fade_depth) {
    if (depth <= View{}) return {};
    return depth >= fade_depth ? View::from_int(1) : divide<View>(depth, fade_depth);
}
View density_above(View depth, View fade_depth) {
    if (depth <= View{}) return {};
    if (depth >= fade_depth) return depth - floor_shift(fade_depth, 1);
    return product_over<View>(depth, depth, fade_depth * 2);
}

/// The depth in full fog that is equivalent to a ray from the eye to depth z.
View length_in_fog(View z, View climb, const HeightFogView& view) {
    const View depth = view.top_above_eye, fade_depth = view.fade_depth;
    const View end_depth = depth - climb;
    if (std::min(depth, end_depth) >= fade_depth) return z;
    if (std::max(depth, end_depth) <= View{}) return {};
    if (absolute(climb) < kLevelClimb) return product<View>(z, density_at(depth - floor_shift(climb, 1), fade_depth));
    return product_over<View>(z, view.density_above_eye - density_above(end_depth, fade_depth), climb);
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

HeightFogView make_height_fog_view(const HeightFog& fog, const Vec3<World>& eye, const ViewDirections& directions) {
    const View depth = convert<View>(widening_difference(fog.top, eye.z));
    const View fade_depth = std::max(convert<View>(fog.fade_depth), View{});
    return {depth, fade_depth, density_above(depth, fade_depth), directions.z};
}

/// A point is above the top if z rise >= top_above_eye; divided by z, this is linear on the screen. The top is taken a
/// unit higher, which exceeds rounding errors, and depths below one unit count as one.
bool is_clear(std::int32_t column, std::int32_t row, InverseZ inverse_z, const HeightFogView& view) {
    const std::int64_t height = floor_of(-view.top_above_eye) - 1;
    if (height < 0 || inverse_z < InverseZ{}) return false;
    const auto steepest = convert<DirectionPart>(std::min(inverse_z, kOne), Rounding::Floor) * height;
    return view.rise.at(column, row) + steepest >= DirectionPart{};
}

bool is_clear(const ScreenRectangle& pixels, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view) {
    const auto is_corner_clear = [&](std::int32_t column, std::int32_t row) {
        return is_clear(column, row, inverse_z.at(column, row), view);
    };
    const std::int32_t last_column = pixels.end_column - 1, last_row = pixels.end_row - 1;
    return is_within(inverse_z.per_column, kOne) && is_within(inverse_z.per_row, kOne) &&
           is_corner_clear(pixels.first_column, pixels.first_row) && is_corner_clear(last_column, pixels.first_row) &&
           is_corner_clear(pixels.first_column, last_row) && is_corner_clear(last_column, last_row);
}

void append_height_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                            const FogDepths& depths, std::vector<FogRun>& runs) {
    if (is_clear({span.first, span.end, span.y, span.y + 1}, inverse_z, view)) return append_fog_run({span, 0}, runs);
    LevelFinder finder(span, inverse_z, view, depths, runs);
    std::int32_t first = span.first, level = finder.level_at(first, FogTable::kLevels / 2);
    for (const std::int32_t last = span.end - 1; first < last;) {
        const std::int32_t end = std::min(first + kStep_px, last), end_level = finder.level_at(end, level);
        finder.append(first, end, level, end_level);
        first = end;
        level = end_level;
    }
    append_fog_run({{span.y, first, span.end}, level}, runs);
}

}  // namespace oblong
