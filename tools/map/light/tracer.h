#pragma once

#include <functional>
#include <map>

#include "tools/map/source/brush.h"
#include "tools/map/source/light.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Where a ray ends.
struct RayHit {
    int contents = 0;  ///< solid or sky; 0: nothing stops it
    double share = 1;  ///< of the distance
    int node = -1;     ///< of the plane on which it ends; -1: it begins in solid
};

/// Two directions perpendicular to a normal and to each other.
std::array<Point, 2> tangents(const Point& normal);

/// Follows rays through the world of a level.
class Tracer {
  public:
    /// `shadow_models`: brush models that are obstacles too, for light from lamps and the sun.
    explicit Tracer(const BspFile& bsp, const std::vector<int>& shadow_models = {});

    /// The first obstacle from `from` to `to`: solid or sky; 0: none.
    int first_opaque(const Point& from, const Point& to) const { return first_in_models(from, to, true); }

    bool is_clear(const Point& from, const Point& to) const { return first_opaque(from, to) == 0; }

    /// Whether no solid is in between. As in Quake's own compiler, the light of lamps passes through a sky.
    bool is_lit(const Point& from, const Point& to) const { return first_in_models(from, to, false) == 0; }

    /// As first_opaque(), with its position.
    RayHit hit(const Point& from, const Point& to) const { return hit_below(root_, from, to, true); }

    /// The index of the leaf that a point is in.
    int leaf_at(const Point& point) const;
    bool is_solid(const Point& point) const { return item(opaque_, leaf_at(point)) == contents::kSolid; }

  private:
    using Place = std::array<double, 3>;  // a point whose components are found without branches
    static Place place_of(const Point& point) { return {point.x, point.y, point.z}; }

    struct TraceNode {
        Place normal{};
        double distance = 0;
        std::array<int, 2> children{};
        int axis = 3;  // of the normal; 3: along none

        double height_of(const Place& p) const {
            if (axis < 3) return item(p, axis) - distance;
            return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] - distance;
        }
    };

    int first_in_models(const Point& from, const Point& to, bool stops_at_sky) const {
        const RayHit met = hit_below(root_, from, to, stops_at_sky);
        if (shadow_roots_.empty() || met.contents == contents::kSolid) return met.contents;
        const Point end = met.contents == 0 ? to : from + (to - from) * met.share;
        const bool is_shaded = std::any_of(shadow_roots_.begin(), shadow_roots_.end(),
                                           [&](int root) { return hit_below(root, from, end, false).contents != 0; });
        return is_shaded ? contents::kSolid : met.contents;
    }
    RayHit hit_below(int root, const Point& from, const Point& to, bool stops_at_sky) const;
    bool find_hit(int child, const Place& from, const Place& to, double from_share, double to_share, bool stops_at_sky,
                  RayHit& hit) const;

    std::vector<TraceNode> nodes_;
    std::vector<int> opaque_;  // contents of each leaf, or 0
    int root_ = 0;
    std::vector<int> shadow_roots_;
};

/// Light by its style.
using StyleLight = std::map<int, Light>;

/// The view from a surface point over its hemisphere, a mean over rays weighted by the cosine of their angle to the
/// normal (Lambert's law).
struct Hemisphere {
    double sky_above = 0, sky_below = 0;  ///< the shares of sky above and below the horizon
    double shut = 0;                      ///< 0: open, 1: enclosed; 1 - d / D for a hit at distance d < D
    StyleLight light;                     ///< the mean light of visible surfaces
};

/// Adds the light of a surface at a point hit by a ray of some direction, times the ray's share.
using AddLight = std::function<void(const Point&, const RayHit&, const Point&, double share, StyleLight&)>;

/// Looks in directions that are evenly distributed by that law, `rings` in each of as many rings: one of kPatterns
/// sets, which together form one finer set. `dirt_depth`: D above. `add_reflected`: null: not needed.
Hemisphere gather(const Point& point, const Point& normal, int rings, int pattern, double dirt_depth,
                  const Tracer& tracer, const AddLight& add_reflected);
inline constexpr int kPatterns = 9;

}  // namespace oblong::map
