#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/vec.h"
#include "engine/mesh/triangulate.h"
#include "engine/view/clip.h"
#include "engine/view/projection.h"

namespace oblong {

/// The triangles of a convex polygon that all share its first corner (course notes): (0, i + 1, i + 2), two fewer than
/// its corners.
inline std::vector<CornerTriple> triangulate_as_fan(std::size_t corner_count) {
    std::vector<CornerTriple> triangles;
    for (std::uint32_t i = 0; i + 2 < corner_count; ++i) triangles.push_back({0, i + 1, i + 2});
    return triangles;
}

/// The triangles of a convex polygon around a point in its middle (middle_of), which becomes corner number
/// `corner_count`: as many as its corners, and better shaped than a fan's.
inline std::vector<CornerTriple> triangulate_around_middle(std::size_t corner_count) {
    const auto middle = static_cast<std::uint32_t>(corner_count);
    std::vector<CornerTriple> triangles;
    for (std::uint32_t i = 0; i < middle; ++i) triangles.push_back({i, (i + 1) % middle, middle});
    return triangles;
}

/// Whether a face faces away from the eye, in any space common to all three (Abrash: before any transform, by one dot
/// product). `normal` is of length 1 and points to the face's front; `point` is any point of it. A face seen edge-on
/// counts as turned away.
constexpr bool faces_away(const Vec3<World>& point, const Vec3<Unit>& normal, const Vec3<World>& eye) {
    return dot(widening_difference(point, eye), normal) >= PlaneDistance{};
}

/// The same from the normal alone: whether it points along the view, its z in viewspace not below 0. Right only for
/// parallel projections. In perspective the rays to faces differ: a face beside the view's middle may face the eye
/// although its normal points away (Abrash's figure 3), and vice versa. For comparison.
constexpr bool normal_points_away(const Vec3<Unit>& normal, const Vec3<Unit>& forward) {
    return dot(normal, forward) >= Sine60{};
}

/// PolygonClipper::clip_to_plane() from `in` to `out`.
inline void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
                          std::vector<ClipVertex>& out) {
    std::vector<ClipVertex> polygon = in;
    PolygonClipper clipper;
    ClipVertex** corner = clipper.start(polygon.size()).data();
    for (ClipVertex& vertex : polygon) *corner++ = &vertex;
    clipper.clip_to_plane(plane, border);
    out.clear();
    for (const ClipVertex* const vertex : clipper.corners()) out.push_back(*vertex);
}

}  // namespace oblong
