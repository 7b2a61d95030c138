#include "engine/methods/canonical_volume.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/methods/transforms.h"

namespace oblong {

namespace {

/// A side of the volume: one coordinate is -w, 0 or w.
struct SideEquation {
    Entry Vec4::*coordinate;
    int times_w;

    Entry at(const Vec4& point) const { return times_w == 0 ? Entry{} : times_w < 0 ? -point.w : point.w; }
};
/// In the order of VolumeSide.
constexpr std::array<SideEquation, kVolumeSideCount> kSides{
    {{&Vec4::x, -1}, {&Vec4::x, 1}, {&Vec4::y, -1}, {&Vec4::y, 1}, {&Vec4::z, 0}, {&Vec4::z, 1}}};

/// The same point with smaller coordinates, so that sums of two, and differences of such sums, fit.
Vec4 with_room(const Vec4& point) {
    constexpr Entry kRoom = Entry::from_int(1 << 29);
    const auto fits = [&](Entry value) { return value < kRoom && value > -kRoom; };
    if (fits(point.x) && fits(point.y) && fits(point.z) && fits(point.w)) return point;
    return {floor_shift(point.x, 2), floor_shift(point.y, 2), floor_shift(point.z, 2), floor_shift(point.w, 2)};
}

Vec4 between(const Vec4& from, const Vec4& to, Entry part, Entry whole) {
    return {between(from.x, to.x, part, whole), between(from.y, to.y, part, whole), between(from.z, to.z, part, whole),
            between(from.w, to.w, part, whole)};
}

/// Where an edge crosses a side, given its end inside and its end outside. Set exactly on the side.
Vec4 cross_side(const Vec4& inside, const Vec4& outside, VolumeSide side) {
    const Entry from_inside = distance_inside(inside, side);
    Vec4 crossing = between(inside, outside, from_inside, from_inside - distance_inside(outside, side));
    crossing.*item(kSides, side).coordinate = item(kSides, side).at(crossing);
    return crossing;
}

}  // namespace

Entry distance_inside(const Vec4& point, VolumeSide side) {
    const Entry coordinate = point.*item(kSides, side).coordinate, border = item(kSides, side).at(point);
    return item(kSides, side).times_w > 0 ? border - coordinate : coordinate - border;
}

unsigned volume_outcode(const Vec4& point) {
    const Vec4 roomy = with_room(point);
    unsigned outcode = 0;
    for (unsigned side = 0; side < kVolumeSideCount; ++side)
        outcode |= static_cast<unsigned>(distance_inside(roomy, static_cast<VolumeSide>(side)) < Entry{}) << side;
    return outcode;
}

SplitPolygon split_polygon(const std::vector<Vec4>& polygon, VolumeSide side) {
    SplitPolygon split;
    if (polygon.empty()) return split;
    Vec4 previous = polygon.back();
    bool was_inside = distance_inside(previous, side) >= Entry{};
    for (const Vec4& corner : polygon) {
        const bool is_inside = distance_inside(corner, side) >= Entry{};
        if (is_inside != was_inside) {
            const Vec4 crossing = is_inside ? cross_side(corner, previous, side) : cross_side(previous, corner, side);
            split.inside.push_back(crossing);
            split.outside.push_back(crossing);
        }
        (is_inside ? split.inside : split.outside).push_back(corner);
        previous = corner;
        was_inside = is_inside;
    }
    return split;
}

std::vector<Vec4> clip_to_volume(const std::vector<Vec4>& polygon) {
    std::vector<Vec4> clipped(polygon.size());
    std::transform(polygon.begin(), polygon.end(), clipped.begin(), with_room);
    for (int side = 0; side < kVolumeSideCount; ++side)
        clipped = split_polygon(clipped, static_cast<VolumeSide>(side)).inside;
    return clipped;
}

Matrix4 volume_matrix(const Projection& projection, Entry nearest, Entry farthest) {
    const auto over_half = [](Multiplier multiplier, std::int32_t size_px) {
        return divide<Entry>(multiplier + multiplier, Fixed<std::int64_t, 0>::from_int(size_px));
    };
    const Entry lambda = divide<Entry>(farthest, farthest - nearest);
    Matrix4 matrix;
    matrix.rows[0][0] = over_half(projection.x.multiplier, projection.width_px);
    matrix.rows[1][1] = over_half(projection.y.multiplier, projection.height_px);
    matrix.rows[2] = {Entry{}, Entry{}, lambda, -multiply(lambda, nearest)};
    matrix.rows[3] = {Entry{}, Entry{}, Entry::from_int(1), Entry{}};
    return matrix;
}

std::array<Matrix4, 5> lab_volume_steps(const WindowView& window) {
    const auto to_origin = [](const Vec4& p) { return translation({-p.x, -p.y, -p.z}); };
    const Matrix4 move = to_origin(homogeneous(window.reference_point));
    const Matrix4 turn = homogeneous(rotation_matrix(window_view(window).axes));
    const Vec4 cop = turn * (move * homogeneous(window.centre_of_projection));
    const Entry distance = -cop.z, back = distance + convert<Entry>(window.back.value());  // VRP'z and B'
    const auto middle = [](World low, World high) {
        return floor_shift(convert<Entry>(low) + convert<Entry>(high), 1);
    };
    const auto scale = [&](World low, World high) {
        return divide<Entry>(distance + distance, multiply(convert<Entry>(high) - convert<Entry>(low), back));
    };
    Matrix4 shear = Matrix4::identity();
    shear.rows[0][2] = -divide<Entry>(middle(window.u_min, window.u_max) - cop.x, distance);
    shear.rows[1][2] = -divide<Entry>(middle(window.v_min, window.v_max) - cop.y, distance);
    return {move, turn, to_origin(cop), shear,
            scaling({scale(window.u_min, window.u_max), scale(window.v_min, window.v_max), reciprocal<Entry>(back)})};
}

VolumeScreenPoint volume_to_screen(const Vec4& point, std::int32_t width_px, std::int32_t height_px) {
    const auto along = [&point](Entry distance, std::int32_t size_px) {
        return product_over<Entry>(distance, Entry::from_int(size_px), point.w + point.w);
    };
    return {along(point.w + point.x, width_px), along(point.w - point.y, height_px), divide<Entry>(point.z, point.w)};
}

}  // namespace oblong
