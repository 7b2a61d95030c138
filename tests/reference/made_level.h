#pragma once

#include <cmath>

#include "engine/reference/level.h"
#include "engine/reference/view.h"

/// Levels made for a test, and the view that most tests look at them through.
namespace oblong::test {

using reference::Vec;

/// From the origin along +x, 160 pixels the unit at depth 1: a point (x, y, z) shows at column 160 - 160 y / x, row
/// 100 - 160 z / x.
inline reference::View make_plain_view() {
    reference::View view;
    view.correct_aspect = false;
    return view;
}

/// The point of the plain view that shows at a place on the screen.
inline Vec shown_at(double column, double row, double depth) {
    return {depth, (160 - column) * depth / 160, (100 - row) * depth / 160};
}

/// A level with one texinfo, u = -y and v = -z: right and down in the plain view.
inline reference::Level make_level() {
    reference::Level level;
    level.textures.push_back({"wall", 16, 16, std::vector<std::uint8_t>(256, 7)});
    level.texinfos.push_back({{0, -1, 0}, {0, 0, -1}, 0, 0, 0, false});
    level.models.resize(1);
    return level;
}

/// Adds a face to the level's last model. Clockwise seen from its front.
inline reference::Face& add_face(reference::Level& level, const std::vector<Vec>& corners) {
    reference::Face face;
    for (const Vec& corner : corners) {
        face.corners.push_back(static_cast<int>(level.vertices.size()));
        level.vertices.push_back(corner);
    }
    const Vec across = cross(corners[2] - corners[0], corners[1] - corners[0]);
    face.plane.normal = across * (1 / std::sqrt(dot(across, across)));
    face.plane.offset = dot(face.plane.normal, corners[0]);
    level.faces.push_back(face);
    ++level.models.back().face_count;
    return level.faces.back();
}

/// A rectangle of the screen of the plain view, at right angles to it.
inline reference::Face& add_rectangle(reference::Level& level, double left, double top, double right, double bottom,
                                      double depth = 160) {
    return add_face(level, {shown_at(left, top, depth), shown_at(right, top, depth), shown_at(right, bottom, depth),
                            shown_at(left, bottom, depth)});
}

}  // namespace oblong::test
