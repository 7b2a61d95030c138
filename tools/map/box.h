#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "tools/map/point.h"

namespace oblong::map {

/// An axis-aligned box; empty until a point is added.
struct Box {
    static constexpr double kFar = std::numeric_limits<double>::max();
    Point mins{kFar, kFar, kFar}, maxs{-kFar, -kFar, -kFar};

    bool is_empty() const { return mins.x > maxs.x; }

    void add(const Point& point) {
        for (int axis = 0; axis < 3; ++axis) {
            component(mins, axis) = std::min(component(mins, axis), component(point, axis));
            component(maxs, axis) = std::max(component(maxs, axis), component(point, axis));
        }
    }

    void add(std::span<const Point> points) {
        for (const Point& point : points) add(point);
    }

    void add(const Box& other) {
        if (other.is_empty()) return;
        add(other.mins);
        add(other.maxs);
    }

    /// This box with every side moved outward by `margin`.
    Box grown(double margin) const {
        const Point by{margin, margin, margin};
        return {mins - by, maxs + by};
    }

    /// Whether the boxes share a point when each is grown by half of `slack`.
    bool touches(const Box& other, double slack) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (component(mins, axis) > component(other.maxs, axis) + slack) return false;
            if (component(maxs, axis) < component(other.mins, axis) - slack) return false;
        }
        return true;
    }
};

inline Box box_of(std::span<const Point> points) {
    Box box;
    box.add(points);
    return box;
}

}  // namespace oblong::map
