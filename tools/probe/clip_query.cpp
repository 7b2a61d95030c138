#include <algorithm>
#include <bit>

#include "engine/geometry/clip.h"
#include "engine/geometry/project.h"
#include "engine/raster/scan.h"
#include "tools/probe/decimal.h"
#include "tools/probe/queries.h"

namespace oblong {

namespace {

constexpr unsigned kAllSides = kOutLeft | kOutRight | kOutBottom | kOutTop;

/// A polygon between two depths. All lengths are multiplied by one power of two, so that they fill the bits that clip
/// planes allow: what is seen through an eye does not depend on the unit of length.
struct ClipJob {
    std::vector<ClipVertex> polygon;
    View near, far;
};

std::int64_t largest_coordinate(const std::vector<Vec3<View>>& corners) {
    std::int64_t largest = 1;
    for (const Vec3<View>& corner : corners)
        for (const View coordinate : {corner.x, corner.y, corner.z})
            largest = std::max(largest, std::abs(coordinate.raw));
    return largest;
}

ClipJob make_job(const std::vector<Vec3<View>>& corners, View near, View far) {
    constexpr int kPositionBits = 34;  // of a sign and 34 bits: ClipPlane
    const std::int64_t largest = largest_coordinate(corners);
    const std::int64_t scale =
        std::int64_t{1} << (kPositionBits - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest))));
    const auto scaled = [scale](View value) { return View::from_raw(value.raw * scale); };
    ClipJob job;
    for (const Vec3<View>& corner : corners)
        job.polygon.push_back({{scaled(corner.x), scaled(corner.y), scaled(corner.z)}, 0});
    // Depths beyond the polygon clip nothing.
    const View beyond = View::from_raw(largest + 1);
    job.near = scaled(std::min(near, beyond));
    job.far = scaled(std::min(far, beyond));
    return job;
}

void clip_to_depth(const ClipPlane& plane, ClipScratch& scratch) {
    if (scratch.polygon.size() < 3) return;
    clip_to_plane(plane, 0, scratch.polygon, scratch.other);
    scratch.polygon.swap(scratch.other);
}

std::vector<ScreenVertex> to_screen(const std::vector<ClipVertex>& polygon, const Projection& lens) {
    const SubpixelGrid grid = SubpixelGrid::of_bits(Screen::kFractionBits);
    std::vector<ScreenVertex> screen;
    for (const ClipVertex& vertex : polygon) {
        const ScreenVertex inside = to_screen_vertex(project(vertex.position, lens), lens, grid);
        screen.push_back(to_screen_border(inside, vertex.borders, lens));
    }
    return screen;
}

/// Twice the area on the screen, (1/256 pixel)^2.
std::int64_t visible_doubled_area_16(const ClipJob& job, const ModeAndView& view) {
    const Projection lens = make_projection(view.mode, view.field_of_view);
    const Frustum frustum = make_frustum(y_up_basis(Angle{}, Angle{}, Angle{}), lens);
    ClipScratch scratch{job.polygon, {}};
    clip_to_depth({{0, 0, 1}, job.near.raw}, scratch);
    clip_to_depth({{0, 0, -1}, -job.far.raw}, scratch);
    clip_polygon(frustum, kAllSides, scratch);
    if (scratch.polygon.empty()) return 0;
    return std::abs(doubled_area_16(to_screen(scratch.polygon, lens)));
}

}  // namespace

std::string answer_clip(Fields& fields) {
    const ModeAndView view = fields.mode();
    const View near = convert<View>(fields.length()), far = convert<View>(fields.length());
    if (near <= View{}) throw Unsupported{};
    const std::int64_t count = fields.integer(3, static_cast<std::int64_t>(fields.left()) / 3);
    std::vector<Vec3<View>> corners;
    for (std::int64_t i = 0; i < count; ++i) corners.push_back(convert_point<View>(fields.point()));
    fields.expect_end();
    return format_fixed(visible_doubled_area_16(make_job(corners, near, far), view), 2 * Screen::kFractionBits + 1);
}

}  // namespace oblong
