#include "engine/methods/polygons.h"

namespace oblong {

std::vector<CornerTriple> triangulate_as_fan(std::size_t corner_count) {
    std::vector<CornerTriple> triangles;
    for (std::uint32_t i = 0; i + 2 < corner_count; ++i) triangles.push_back({0, i + 1, i + 2});
    return triangles;
}

std::vector<CornerTriple> triangulate_around_middle(std::size_t corner_count) {
    const auto middle = static_cast<std::uint32_t>(corner_count);
    std::vector<CornerTriple> triangles;
    for (std::uint32_t i = 0; i < middle; ++i) triangles.push_back({i, (i + 1) % middle, middle});
    return triangles;
}

void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
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
