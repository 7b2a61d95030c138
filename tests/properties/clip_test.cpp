// Closed surfaces clipped to the four sides of random views. One plane at a time: HardCaseC1 to HardCaseC3.

#include "engine/view/clip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"

namespace oblong::test {
namespace {

using ViewPoint = Vec3<View>;

/// Of a mode and a field of view, any that the engine takes.
Frustum any_frustum() {
    ScreenMode mode;
    mode.width_px = *rc::gen::inRange(16, 2'048);
    mode.height_px = *rc::gen::inRange(16, 2'048);
    const Degrees field_of_view = Degrees::from_int(*rc::gen::inRange(10, 170));
    return make_frustum(y_up_basis({}, {}, {}), make_projection(mode, field_of_view));
}

/// As a frame clips: to the sides that the polygon's own corners are outside of.
std::vector<ClipVertex> clipped_as_in_a_frame(const Frustum& frustum, const std::vector<ViewPoint>& corners) {
    ClipScratch scratch;
    unsigned any_outside = 0, all_outside = 0xff;
    for (const ViewPoint& corner : corners) {
        const std::uint8_t outcode = outcode_of(frustum, corner);
        any_outside |= outcode;
        all_outside &= outcode;
        scratch.polygon.push_back({corner, 0, outcode, 0});
    }
    if (all_outside != 0) return {};
    if (any_outside != 0) clip_polygon(frustum, any_outside, scratch);
    return scratch.polygon;
}

/// An edge of a clipped polygon: where it begins and ends, and the borders that both ends are on.
using ClippedEdge = std::array<ViewPoint, 2>;

bool has_edge(const std::vector<ClipVertex>& polygon, const ClippedEdge& edge) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (polygon[i].position == edge[0] && polygon[(i + 1) % polygon.size()].position == edge[1]) return true;
    return false;
}

/// The edges within the view: those that clipping did not lay on a border.
std::vector<ClippedEdge> inner_edges(const std::vector<ClipVertex>& polygon) {
    std::vector<ClippedEdge> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        if ((from.borders & to.borders) == 0 && from.position != to.position)
            edges.push_back({from.position, to.position});
    }
    return edges;
}

/// A tetrahedron is closed: clipped face by face, near the eye where positions are coarse, each edge in view is still
/// walked once forth and once back, bit for bit.
RC_GTEST_PROP(PropertyClip, ClosedSurfacesStayClosedWithinTheView, ()) {
    const Frustum frustum = any_frustum();
    const std::int64_t size_16 = *rc::gen::element<std::int64_t>(3, 8, 40, 900, 65'536, 20'000'000);
    const auto any_corner = [&] {
        const auto along = [&] { return View::from_raw(*rc::gen::inRange(-size_16, size_16 + 1)); };
        return ViewPoint{along(), along(), along()};
    };
    const ViewPoint a = any_corner(), b = any_corner(), c = any_corner(), d = any_corner();
    std::vector<std::vector<ClipVertex>> faces;
    for (const std::vector<ViewPoint>& corners : {std::vector{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}})
        faces.push_back(clipped_as_in_a_frame(frustum, corners));
    for (const auto& face : faces)
        for (const ClippedEdge& edge : inner_edges(face)) {
            const auto is_its_back = [&](const auto& other) { return has_edge(other, {edge[1], edge[0]}); };
            RC_ASSERT(std::any_of(faces.begin(), faces.end(), is_its_back));
        }
}

}  // namespace
}  // namespace oblong::test
