#pragma once

#include <cmath>
#include <vector>

#include "engine/view/screen_polygon.h"
#include "tools/reference/projection.h"

namespace oblong::test {

/// The frame's own way from a polygon in the world to its polygon on the screen: 320x200 on 4:3, 90 degrees across, the
/// eye at the origin, and the world's axes those of viewspace.
struct FrameOutline {
    ViewContext view;
    ScreenPolygon polygon;

    FrameOutline() {
        view.axes = y_up_basis({}, {}, {});
        view.viewpoint = {view.eye};
        view.rays = view.axes;
        view.projection = make_projection({}, Degrees::from_int(90));
        view.frustum = make_frustum(view.axes, view.projection);
        view.grid = SubpixelGrid::of_bits(8);
    }

    bool make(const std::vector<reference::Vec>& corners) {
        std::vector<Vec3<World>> world;
        const auto raw = [](double value) {
            return World::from_raw(static_cast<std::int32_t>(std::llround(value * 4096)));
        };
        for (const reference::Vec& corner : corners) world.push_back({raw(corner.x), raw(corner.y), raw(corner.z)});
        return project_polygon(world, view, polygon);
    }

    /// The same as an polygon of pixels; empty where nothing is in view.
    std::vector<reference::ScreenPoint> points_of(const std::vector<reference::Vec>& corners) {
        std::vector<reference::ScreenPoint> points;
        if (make(corners))
            for (const ScreenVertex& vertex : polygon.screen)
                points.push_back({vertex.x.raw / 256.0, vertex.y.raw / 256.0});
        return points;
    }
};

}  // namespace oblong::test
