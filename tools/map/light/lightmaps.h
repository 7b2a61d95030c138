#pragma once

#include "tools/map/source/brush.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/geometry.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Gives every lit face a lightmap of direct light: of each source that a sample sees, what arrives at its distance,
/// times (1 + the cosine of the angle of incidence) / 2, halved (so that 255 is twice as bright as a lamp of 255 at
/// no distance). Each light style is a lightmap of its own, at most four for a face: the brightest. A face without
/// light gets none. `is_fast`: one ray a sample and source instead of sixteen. `warnings`, if there are any, name the
/// lamps that stand in walls and light nothing.
void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, bool is_fast, Warnings* warnings);

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
    bool is_solid(const Point& point) const { return item(opaque_, leaf_at(point)) == contents::kSolid; }

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
