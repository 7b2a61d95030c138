#pragma once

#include "tools/map/source/brush.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Where a ray ends.
struct RayHit {
    int contents = 0;  ///< solid or sky; 0: nothing stops it
    double share = 1;  ///< of the distance
    int node = -1;     ///< of the plane on which it ends; -1: it begins in solid
};

/// Follows rays through the world of a level.
class Tracer {
  public:
    explicit Tracer(const BspFile& bsp);

    /// The first obstacle from `from` to `to`: solid or sky; 0: none.
    int first_opaque(const Point& from, const Point& to) const { return follow(root_, from, to, true); }

    bool is_clear(const Point& from, const Point& to) const { return first_opaque(from, to) == 0; }

    /// Whether no solid is in between. As in Quake's own compiler, the light of lamps passes through a sky.
    bool is_lit(const Point& from, const Point& to) const { return follow(root_, from, to, false) == 0; }

    /// As first_opaque(), with its position.
    RayHit hit(const Point& from, const Point& to) const;

    /// The index of the leaf that a point is in.
    int leaf_at(const Point& point) const;
    bool is_solid(const Point& point) const { return item(opaque_, leaf_at(point)) == contents::kSolid; }

  private:
    struct TraceNode {
        Point normal;
        double distance = 0;
        std::array<int, 2> children{};
        int axis = 3;  // of the normal; 3: along none

        double height_of(const Point& point) const { return (axis < 3 ? point[axis] : dot(normal, point)) - distance; }
    };

    int follow(int child, const Point& from, const Point& to, bool stops_at_sky) const;
    bool find_hit(int child, const Point& from, const Point& to, double from_share, double to_share, RayHit& hit) const;

    std::vector<TraceNode> nodes_;
    std::vector<int> opaque_;  // contents of each leaf, or 0
    int root_ = 0;
};

}  // namespace oblong::map
