#pragma once

#include "tools/map/source/contents.h"
#include "tools/map/source/geometry.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Follows rays through the world of a level.
class Tracer {
  public:
    explicit Tracer(const BspFile& bsp);

    /// What stops the way from `from` to `to` first: solid or sky; 0 if nothing does.
    int first_opaque(const Point& from, const Point& to) const { return follow(root_, from, to, true); }

    bool is_clear(const Point& from, const Point& to) const { return first_opaque(from, to) == 0; }

    /// Whether no solid stops the way. As in Quake's own compiler, the light of lamps passes through a sky.
    bool is_lit(const Point& from, const Point& to) const { return follow(root_, from, to, false) == 0; }

    /// The index of the leaf that a point is in.
    int leaf_at(const Point& point) const;
    bool is_solid(const Point& point) const { return at(opaque_, leaf_at(point)) == contents::kSolid; }

  private:
    struct TraceNode {
        Point normal;
        double distance = 0;
        std::array<int, 2> children{};
    };

    int follow(int child, const Point& from, const Point& to, bool stops_at_sky) const;

    std::vector<TraceNode> nodes_;
    std::vector<int> opaque_;  // contents of each leaf, or 0
    int root_ = 0;
};

}  // namespace oblong::map
