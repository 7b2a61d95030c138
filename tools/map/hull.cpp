#include "tools/map/hull.h"

#include <algorithm>

namespace oblong::map {
namespace {

constexpr double kSupportEpsilon = 1.0 / 512;

// How far the brush reaches along a direction.
double support(const Brush& brush, const Point& direction) {
    double farthest = -Box::kFar;
    for (const BrushSide& side : brush.sides) {
        for (const Point& point : side.winding) farthest = std::max(farthest, dot(direction, point));
    }
    return farthest;
}

// How far the mover's mirror image reaches along a direction.
double mirrored_support(const Box& mover, const Point& direction) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = component(direction, axis);
        sum += std::max(-along * component(mover.mins, axis), -along * component(mover.maxs, axis));
    }
    return sum;
}

class Grower {
  public:
    Grower(const Brush& brush, const Box& mover, PlaneList& planes) : brush_(brush), mover_(mover), planes_(planes) {
        grown_.contents = contents::kSolid;
    }

    void add(const Point& normal, double distance) {
        const PlaneSide plane = planes_.find_or_add({normal, distance + mirrored_support(mover_, normal)});
        const bool is_known = std::any_of(grown_.sides.begin(), grown_.sides.end(),
                                          [&](const BrushSide& side) { return side.plane == plane; });
        if (!is_known) grown_.sides.push_back({plane, -1, {}});
    }

    // The plane through an edge of the brush and an edge of the box, if it touches the brush in that edge only.
    void add_edge_bevels(const Point& from, const Point& to) {
        for (int axis = 0; axis < 3; ++axis) {
            const Point across = cross(to - from, axis_vector(axis));
            const double size = length(across);
            if (size < kSupportEpsilon * length(to - from)) continue;
            for (const double sign : {1.0, -1.0}) {
                const Point normal = scaled(across, sign / size);
                if (support(brush_, normal) < dot(normal, from) + kSupportEpsilon) add(normal, dot(normal, from));
            }
        }
    }

    Brush finish() {
        set_windings(grown_, planes_);
        return std::move(grown_);
    }

  private:
    const Brush& brush_;
    const Box& mover_;
    PlaneList& planes_;
    Brush grown_;
};

}  // namespace

Brush expanded(const Brush& brush, const Box& mover, PlaneList& planes) {
    Grower grower(brush, mover, planes);
    for (const BrushSide& side : brush.sides) {
        const Plane plane = planes.facing(side.plane);
        grower.add(plane.normal, plane.distance);
    }
    for (int axis = 0; axis < 3; ++axis) {
        grower.add(axis_vector(axis), component(brush.box.maxs, axis));
        grower.add(-axis_vector(axis), -component(brush.box.mins, axis));
    }
    for (const BrushSide& side : brush.sides) {
        for (std::size_t i = 0; i < side.winding.size(); ++i)
            grower.add_edge_bevels(side.winding[i], side.winding[(i + 1) % side.winding.size()]);
    }
    return grower.finish();
}

std::vector<Brush> hull_brushes(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes) {
    std::vector<Brush> grown;
    for (const Brush& brush : brushes) {
        if (is_opaque(brush.contents)) grown.push_back(expanded(brush, mover, planes));
    }
    return grown;
}

}  // namespace oblong::map
