#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "engine/methods/transforms.h"
#include "engine/reference/view.h"
#include "engine/view/screen_polygon.h"
#include "tests/support/random.h"
#include "tests/support/views.h"
#include "tools/probe/probe.h"

/// Each hard case is a test suite HardCaseLETTERNUMBER: README.md lists them. Many ask through the probe, as checks
/// from outside do.

namespace oblong::test {

inline std::string ask(const std::string& line) {
    return Probe().answer(line);
}

/// The numbers of an answer; none where it is a word.
inline std::vector<double> ask_numbers(const std::string& line) {
    std::istringstream in(ask(line));
    std::vector<double> numbers;
    for (double number; in >> number;) numbers.push_back(number);
    return numbers;
}

/// Fields separated by spaces.
template <class... Values>
std::string join(const Values&... values) {
    std::ostringstream out;
    out.precision(12);
    std::size_t index = 0;
    ((out << (index++ ? " " : "") << values), ...);
    return out.str();
}

/// The nearest multiple of 1/256: what lengths of queries are.
inline double snapped(double value) {
    return std::nearbyint(value * 256) / 256;
}

inline std::int32_t random_integer(std::mt19937& random, std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random);
}

/// Of 320x200 on 4:3, 90 degrees across.
inline const reference::Projection kProjection = reference::make_projection(320, 200, 4.0 / 3, 90);

/// The frame's own way from a polygon in the world to its polygon on the screen: 320x200 on 4:3, 90 degrees across, the
/// eye at the origin, and the world's axes those of viewspace.
struct FrameOutline {
    ViewContext view = view_along({}, y_up_basis({}, {}, {}));
    ScreenPolygon polygon;

    bool make(const std::vector<reference::Vec>& corners) {
        std::vector<Vec3<World>> world;
        for (const reference::Vec& corner : corners) world.push_back(to_world(corner));
        return project_polygon(world, view, polygon);
    }

    /// The same as an polygon of pixels; empty where nothing is in view.
    std::vector<reference::ScreenPoint> points_of(const std::vector<reference::Vec>& corners) {
        std::vector<reference::ScreenPoint> points;
        if (make(corners))
            for (const ScreenVertex& vertex : polygon.vertices)
                points.push_back({vertex.x.raw / 256.0, vertex.y.raw / 256.0});
        return points;
    }
};

}  // namespace oblong::test
