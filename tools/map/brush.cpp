#include "tools/map/brush.h"

#include <algorithm>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

Plane plane_of(const MapSide& side) {
    Point normal = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
    normal = scaled(normal, 1 / length(normal));
    return {normal, dot(normal, side.points[0])};
}

bool has_side(const Brush& brush, PlaneSide plane) {
    return std::any_of(brush.sides.begin(), brush.sides.end(),
                       [&](const BrushSide& side) { return side.plane == plane; });
}

// Brushes of many sides and small ones: they would cut the space around them into many leaves.
constexpr std::size_t kMostStructuralSides = 8;
constexpr double kLeastStructuralExtent = 64;

bool looks_like_detail(const Brush& brush) {
    const Point size = brush.box.maxs - brush.box.mins;
    return !is_liquid(brush.contents) &&
           (brush.sides.size() > kMostStructuralSides || std::max({size.x, size.y, size.z}) <= kLeastStructuralExtent);
}

Winding winding_of(const Brush& brush, const BrushSide& side, const PlaneList& planes) {
    Winding winding = whole_plane(planes.facing(side.plane));
    for (const BrushSide& other : brush.sides) {
        if (other.plane.plane == side.plane.plane) continue;
        winding = clipped_to_back(winding, planes.facing(other.plane));
        if (winding.empty()) break;
    }
    return winding;
}

}  // namespace

Brush make_brush(const MapBrush& source, PlaneList& planes, TextureList& textures) {
    Brush brush;
    for (const MapSide& side : source.sides) {
        const PlaneSide plane = planes.find_or_add(plane_of(side));
        if (!has_side(brush, plane))
            brush.sides.push_back({plane, textures.find_or_add(side, planes.facing(plane).normal), {}});
    }
    if (!set_windings(brush, planes))
        throw InputError("line " + std::to_string(source.line),
                         "the sides of this brush enclose no volume, expected a closed convex solid");
    const std::string& name = source.sides[0].texture.name;
    brush.contents = contents_of_texture(name);
    brush.is_clip = name == "clip";
    brush.is_detail = looks_like_detail(brush);
    return brush;
}

bool set_windings(Brush& brush, const PlaneList& planes) {
    for (BrushSide& side : brush.sides) side.winding = winding_of(brush, side, planes);
    std::erase_if(brush.sides, [](const BrushSide& side) { return side.winding.size() < 3; });
    brush.box = Box{};
    for (const BrushSide& side : brush.sides) brush.box.add(side.winding);
    if (brush.sides.size() < 4) return false;
    const Box all{{-kHuge / 2, -kHuge / 2, -kHuge / 2}, {kHuge / 2, kHuge / 2, kHuge / 2}};
    return !std::any_of(brush.sides.begin(), brush.sides.end(), [&](const BrushSide& side) {
        return std::any_of(side.winding.begin(), side.winding.end(),
                           [&](const Point& point) { return !box_of(std::span(&point, 1)).touches(all, 0); });
    });
}

bool contains(const Brush& brush, const PlaneList& planes, const Point& point, double slack) {
    return std::all_of(brush.sides.begin(), brush.sides.end(),
                       [&](const BrushSide& side) { return planes.facing(side.plane).height_of(point) <= slack; });
}

int contents_at(const std::vector<Brush>& brushes, const PlaneList& planes, const Point& point) {
    int found = contents::kEmpty;
    const Box at = box_of(std::span(&point, 1));
    for (const Brush& brush : brushes) {
        if (contents_rank(brush.contents) <= contents_rank(found) || !brush.box.touches(at, 0)) continue;
        if (contains(brush, planes, point)) found = brush.contents;
    }
    return found;
}

}  // namespace oblong::map
