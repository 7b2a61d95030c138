#include "tests/map/brush_world.h"

#include <algorithm>

#include "tools/map/source/map_file.h"

namespace oblong::test {

using map::Plane;
using map::Point;

namespace {

// Three points of a side run clockwise seen from outside.
Plane outward_plane(const map::MapSide& side) {
    const auto& [a, b, c] = side.points;
    const Point across = cross(c - a, b - a);
    const Point normal = across * (1 / length(across));
    return {normal, dot(normal, a)};
}

bool is_of_world(const map::MapEntity& entity) {
    const std::string name = entity.value("classname");
    return name == "worldspawn" || name == "func_group" || name == "func_detail";
}

bool is_in_the_way(const map::MapBrush& brush) {
    const std::string& name = brush.sides.front().texture.name;
    return !name.starts_with("*") && name != "clip";
}

}  // namespace

BrushWorld::BrushWorld(std::string_view map_text) {
    for (const map::MapEntity& entity : map::parse_map(map_text)) {
        if (!is_of_world(entity)) continue;
        for (const map::MapBrush& brush : entity.brushes) {
            if (!is_in_the_way(brush)) continue;
            Solid& solid = solids_.emplace_back();
            for (const map::MapSide& side : brush.sides) {
                solid.sides.push_back(outward_plane(side));
                box_.add(side.points);
            }
        }
    }
}

bool BrushWorld::is_solid(const Point& point, double margin) const {
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
        return std::all_of(solid.sides.begin(), solid.sides.end(),
                           [&](const Plane& side) { return side.height_of(point) < margin; });
    });
}

bool BrushWorld::is_blocked(const Point& from, const Point& to, double margin) const {
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
        double enter = 0, leave = 1;
        for (const Plane& side : solid.sides) {
            const double begin = side.height_of(from) - margin, end = side.height_of(to) - margin;
            if (begin > 0 && end > 0) return false;
            if (begin > 0) enter = std::max(enter, begin / (begin - end));
            if (end > 0) leave = std::min(leave, begin / (begin - end));
        }
        return enter <= leave;
    });
}

}  // namespace oblong::test
