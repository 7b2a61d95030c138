#pragma once

#include <numbers>
#include <vector>

#include "tools/demo_level/models/obj_draft.h"

namespace oblong::model_source {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// How wide a turned body is at a height.
struct ProfilePoint {
    double radius, y;
};

/// A profile, from the bottom up, turned about the y axis.
std::vector<std::vector<ModelPoint>> turned(const std::vector<ProfilePoint>& profile, int sides);

/// Each point moved by `place`.
template <class Place>
std::vector<std::vector<ModelPoint>> placed_rows(std::vector<std::vector<ModelPoint>> rows, Place place) {
    for (auto& row : rows)
        for (ModelPoint& point : row) point = place(point);
    return rows;
}

/// A profile turned about the y axis and then placed, smooth within itself.
template <class Place>
void add_turned(ObjDraft& draft, const std::vector<ProfilePoint>& profile, int sides, Place place) {
    draft.begin_smooth_part();
    draft.add_closed_grid(placed_rows(turned(profile, sides), place));
}

/// A ring's shape: a band between two radii, so high.
struct Band {
    double inner, outer, height;
};

/// A ring about the y axis and then placed; each of its four sides is smooth in itself. `shown` of 3 leaves out the one
/// inside, that a lens fills.
template <class Place>
void add_ring(ObjDraft& draft, const Band& band, int sides, Place place, std::size_t shown = 4) {
    const double low = -band.height / 2, high = band.height / 2;
    const std::vector<ProfilePoint> outline{
        {band.inner, low}, {band.outer, low}, {band.outer, high}, {band.inner, high}, {band.inner, low}};
    for (std::size_t side = 0; side < shown; ++side)
        add_turned(draft, {outline[side], outline[side + 1]}, sides, place);
}

/// A sphere about the origin.
std::vector<ProfilePoint> sphere_profile(double radius, int rows);

/// Glass between two spherical surfaces that meet in a rim of this radius, each of so many rows.
std::vector<ProfilePoint> lens_profile(double radius, double half_thickness, int rows);

}  // namespace oblong::model_source
