#include "tools/map/source/brush.h"

#include <algorithm>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

// Small brushes and those with many sides would cut the space around them into many leaves.
constexpr std::size_t kMostStructuralSides = 8;
constexpr double kLeastStructuralExtent = 64;

bool looks_like_detail(const Brush& brush) {
    const Point size = brush.box.maxs - brush.box.mins;
    return !is_liquid(brush.contents) &&
           (brush.sides.size() > kMostStructuralSides || std::max({size.x, size.y, size.z}) <= kLeastStructuralExtent);
}

Winding winding_of(const Brush& brush, const BrushSide& side, const PlaneList& planes) {
    Winding winding = whole_plane(planes.facing(side.plane)), spare;
    for (const BrushSide& other : brush.sides) {
        if (other.plane.plane == side.plane.plane) continue;
        clip_to_front(winding, planes.facing({other.plane.plane, !other.plane.is_back}), spare);
        if (winding.empty()) break;
    }
    return winding;
}

constexpr double kSupportEpsilon = 1.0 / 512;

bool is_axial(const Point& direction) {
    return (direction.x == 0) + (direction.y == 0) + (direction.z == 0) >= 2;
}

// The brush's extent along a direction.
double support(const Brush& brush, const Point& direction) {
    double farthest = -Box::kFar;
    for (const BrushSide& side : brush.sides)
        for (const Point& point : side.winding) farthest = std::max(farthest, dot(direction, point));
    return farthest;
}

bool contains(const Brush& brush, const PlaneList& planes, const Point& point) {
    return std::all_of(brush.sides.begin(), brush.sides.end(),
                       [&](const BrushSide& side) { return planes.facing(side.plane).height_of(point) <= 0; });
}

// The normals of the planes through an edge of the brush and an edge of a box that touch the brush only in that edge.
std::vector<Point> edge_bevels(const Brush& brush, const Point& from, const Point& to) {
    std::vector<Point> normals;
    for (int axis = 0; axis < 3; ++axis) {
        const Point across = cross(to - from, axis_vector(axis));
        const double size = length(across);
        if (is_axial(across) || size < kSupportEpsilon * length(to - from)) continue;  // the box's sides are there
        for (const double sign : {1.0, -1.0}) {
            const Point normal = across * (sign / size);
            if (support(brush, normal) < dot(normal, from) + kSupportEpsilon) normals.push_back(normal);
        }
    }
    return normals;
}

}  // namespace

Plane plane_of(const MapSide& side) {
    const Point normal = unit(cross(side.points[0] - side.points[1], side.points[2] - side.points[1]));
    return {normal, dot(normal, side.points[0])};
}

Brush make_brush(const MapBrush& source, PlaneList& planes, TextureList& textures) {
    Brush brush = start_brush(source, planes, textures);
    complete_brush(brush, planes);
    return brush;
}

Brush start_brush(const MapBrush& source, PlaneList& planes, TextureList& textures) {
    Brush brush;
    brush.line = source.line;
    for (const MapSide& side : source.sides) {
        const PlaneSide plane = planes.find_or_add(plane_of(side));
        if (!brush.has_side(plane))
            brush.sides.push_back({plane, textures.find_or_add(side, planes.facing(plane).normal), {}});
    }
    if (source.sides.empty()) return brush;
    const std::string& name = source.sides[0].texture.name;
    brush.contents = contents_of_texture(name);
    brush.is_clip = name == "clip";
    return brush;
}

void complete_brush(Brush& brush, const PlaneList& planes) {
    if (!set_windings(brush, planes))
        throw InputError(at_line(brush.line),
                         "the sides of this brush enclose no volume, expected a closed convex solid, and each side's "
                         "points clockwise seen from outside");
    constexpr int kFarthest = 32767;  // a node's box has 16 bits
    if (brush.box.largest_coordinate() > kFarthest)
        throw InputError(at_line(brush.line), "this brush reaches farther from the origin than " +
                                                  std::to_string(kFarthest) + " units, expected it nearer");
    brush.is_detail = brush.is_detail || looks_like_detail(brush);
}

bool set_windings(Brush& brush, const PlaneList& planes) {
    for (BrushSide& side : brush.sides) side.winding = winding_of(brush, side, planes);
    std::erase_if(brush.sides, [](const BrushSide& side) { return side.winding.size() < 3; });
    brush.box = Box{};
    for (const BrushSide& side : brush.sides) brush.box.add(side.winding);
    return brush.sides.size() >= 4 && brush.box.largest_coordinate() <= kHuge / 2;
}

Winding cut_by_brush(const Winding& winding, const Brush& brush, const PlaneList& planes,
                     std::vector<Winding>& outside) {
    const std::size_t known = outside.size();
    Winding inside = winding;
    for (const BrushSide& side : brush.sides) {
        SplitWinding parts = split(std::move(inside), planes.facing(side.plane));
        if (!parts.is_on && !parts.front.empty()) outside.push_back(std::move(parts.front));
        inside = std::move(parts.is_on ? parts.front : parts.back);
        if (!inside.empty()) continue;
        outside.resize(known);
        outside.push_back(winding);
        break;
    }
    return inside;
}

BrushContents::BrushContents(const std::vector<Brush>& brushes, const PlaneList& planes) : planes_(planes) {
    for (const Brush& brush : brushes)
        for (int x = cell_of(brush.box.mins.x); x <= cell_of(brush.box.maxs.x); ++x)
            for (int y = cell_of(brush.box.mins.y); y <= cell_of(brush.box.maxs.y); ++y)
                in_cells_[{x, y}].push_back(&brush);
}

int BrushContents::at(const Point& point) const {
    int found = contents::kEmpty;
    const auto cell = in_cells_.find({cell_of(point.x), cell_of(point.y)});
    if (cell == in_cells_.end()) return found;
    const Box box{point, point};
    for (const Brush* brush : cell->second) {
        if (contents_rank(brush->contents) <= contents_rank(found) || !brush->box.touches(box, 0)) continue;
        if (contains(*brush, planes_, point)) found = brush->contents;
    }
    return found;
}

Brush expanded(const Brush& brush, const Box& mover, PlaneList& planes) {
    Brush grown;
    const auto add = [&](const Point& normal, double distance) {
        const double reach_of_mover = dot(-normal, farthest_corner(mover, -normal));  // of its mirror image
        const PlaneSide plane = planes.find_or_add({normal, distance + reach_of_mover});
        if (!grown.has_side(plane)) grown.sides.push_back({plane, -1, {}});
    };
    for (const BrushSide& side : brush.sides) {
        const Plane plane = planes.facing(side.plane);
        add(plane.normal, plane.distance);
    }
    for (int axis = 0; axis < 3; ++axis) {
        add(axis_vector(axis), brush.box.maxs[axis]);
        add(-axis_vector(axis), -brush.box.mins[axis]);
    }
    for (const BrushSide& side : brush.sides)
        for (std::size_t i = 0; i < side.winding.size(); ++i) {
            const Point &from = side.winding[i], &to = side.winding[(i + 1) % side.winding.size()];
            for (const Point& normal : edge_bevels(brush, from, to)) add(normal, dot(normal, from));
        }
    return grown;
}

std::vector<Brush> hull_brushes(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes) {
    std::vector<Brush> grown;
    for (const Brush& brush : brushes)
        if (is_opaque(brush.contents)) grown.push_back(expanded(brush, mover, planes));
    return grown;
}

}  // namespace oblong::map
