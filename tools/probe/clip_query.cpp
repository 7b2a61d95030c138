#include <algorithm>

#include "engine/math/soft_float.h"
#include "engine/math/vec.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/raster/scan.h"
#include "engine/view/clip.h"
#include "engine/view/project.h"
#include "tools/probe/fields.h"
#include "tools/probe/probe.h"

namespace oblong {

namespace {

constexpr unsigned kFourSides = kOutLeft | kOutRight | kOutBottom | kOutTop;

/// A polygon between two depths. All lengths are scaled by one power of two to use all bits that clip planes allow: the
/// view does not depend on the unit of length.
struct ClipJob {
    std::vector<ClipVertex> polygon;
    View near, far;
};

using Corner = Vec3<Fixed<std::int32_t, 8>>;

/// Whether the eye lies in the polygon's plane, from which it is invisible. Exact, by six times the volume between eye
/// and polygon: a frame moves its eye off such planes before clipping, which alone would leave a sliver.
bool is_edge_on(const std::vector<Corner>& corners) {
    WideSum volume;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const auto normal = cross(corners[i - 1], corners[i]);
        volume.add_product(corners[0].x, normal.x);
        volume.add_product(corners[0].y, normal.y);
        volume.add_product(corners[0].z, normal.z);
    }
    return volume.scaled(0).is_zero();
}

View largest_coordinate(const std::vector<Vec3<View>>& corners) {
    View largest = View::ulp();
    for (const Vec3<View>& corner : corners)
        for (const View coordinate : {corner.x, corner.y, corner.z}) largest = std::max(largest, absolute(coordinate));
    return largest;
}

ClipJob make_job(const std::vector<Corner>& fine_corners, View near, View far) {
    std::vector<Vec3<View>> corners;
    for (const Corner& corner : fine_corners) corners.push_back(convert<View>(corner));
    constexpr int kPositionBits = 34;  // of a sign and 34 bits: ClipPlane
    const View largest = largest_coordinate(corners);
    const std::int64_t scale = std::int64_t{1} << (kPositionBits - 1 - log2_floor(largest));
    ClipJob job;
    for (const Vec3<View>& corner : corners)
        job.polygon.push_back({{corner.x * scale, corner.y * scale, corner.z * scale}, 0});
    // Depths beyond the polygon clip nothing.
    const View beyond = largest + View::ulp();
    // Before the eye, even if the query's plane is not: the sides of the view meet at the eye.
    constexpr View kLeastNear = View::from_raw(4);
    job.near = std::max(std::min(near, beyond) * scale, kLeastNear);
    job.far = std::min(far, beyond) * scale;
    return job;
}

/// Clips to a plane perpendicular to the view, with its own bit in outcodes.
void clip_to_depth(const ClipPlane& plane, std::uint8_t border, ClipScratch& scratch) {
    if (scratch.polygon.size() < 3) return;
    clip_to_plane(plane, border, scratch.polygon, scratch.other);
    scratch.polygon.swap(scratch.other);
}

std::vector<ScreenVertex> to_screen(const std::vector<ClipVertex>& polygon, const Projection& projection) {
    const SubpixelGrid grid = SubpixelGrid::of_bits(Screen::kFractionBits);
    std::vector<ScreenVertex> screen;
    for (const ClipVertex& vertex : polygon) {
        const ScreenVertex inside = to_screen_vertex(vertex.position, projection, grid);
        screen.push_back(to_screen_border(inside, vertex.borders, projection));
    }
    return screen;
}

/// How often a mode's sizes can be doubled: the finer mode shows the same picture, and slivers keep their area when
/// corners are rounded to 1/256 of its pixels. Not where the field of view makes multipliers too large.
int refinement_of(const ModeAndView& view) {
    constexpr std::int32_t kFinest_px = 1 << 16;
    constexpr Degrees kNarrow = floor_shift(Degrees::from_int(1), 6);
    if (view.field_of_view < kNarrow) return 0;
    int doublings = 0;
    while (std::max(view.mode.width_px, view.mode.height_px) << (doublings + 1) <= kFinest_px) ++doublings;
    return doublings;
}

Projection make_refined_lens(const ModeAndView& view, int doublings) {
    ModeAndView refined = view;
    refined.mode.width_px <<= doublings;
    refined.mode.height_px <<= doublings;
    return frame_lens(refined);
}

/// Twice the area on the screen, in pixels of the projection's mode.
ScreenArea visible_doubled_area(const ClipJob& job, const Projection& projection) {
    const Frustum frustum = make_frustum(y_up_basis(Angle{}, Angle{}, Angle{}), projection);
    ClipScratch scratch{job.polygon, {}};
    constexpr ClipNormal kStep = ClipNormal::ulp();
    clip_to_depth({{{}, {}, kStep}, bounded_product(kStep, job.near)}, 32, scratch);
    clip_to_depth({{{}, {}, -kStep}, -bounded_product(kStep, job.far)}, 64, scratch);
    clip_polygon(frustum, kFourSides, scratch);
    if (scratch.polygon.empty()) return {};
    return absolute(doubled_area(to_screen(scratch.polygon, projection)));
}

}  // namespace

std::string answer_clip(Fields& fields, const Accuracy&) {
    const ModeAndView view = fields.mode();
    const View near = convert<View>(fields.length()), far = convert<View>(fields.length());
    const std::int64_t count = fields.integer(3, static_cast<std::int64_t>(fields.left()) / 3);
    std::vector<Corner> corners;
    for (std::int64_t i = 0; i < count; ++i) corners.push_back(fields.point());
    fields.expect_end();
    if (is_edge_on(corners)) return "0";

    const int doublings = refinement_of(view);
    const ScreenArea area = visible_doubled_area(make_job(corners, near, far), make_refined_lens(view, doublings));
    return format_fixed(area.raw, ScreenArea::kFractionBits + 2 * doublings + 1);
}

}  // namespace oblong
