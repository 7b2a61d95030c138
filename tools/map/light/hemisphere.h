#pragma once

#include <functional>
#include <map>

#include "tools/map/light/tracer.h"

namespace oblong::map {

/// Light by its style.
using StyleLight = std::map<int, double>;

/// The view from a surface point over its hemisphere, a mean over rays weighted by the cosine of their angle to the
/// normal (Lambert's law).
struct Hemisphere {
    double sky_above = 0, sky_below = 0;  ///< the shares of sky above and below the horizon
    double shut = 0;                      ///< 0: open, 1: enclosed; 1 - d / D for a hit at distance d < D
    StyleLight light;                     ///< the mean light of visible surfaces
};

/// Adds the light of a surface at a point hit by a ray of some direction, times the ray's share.
using AddLight = std::function<void(const Point&, const RayHit&, const Point&, double share, StyleLight&)>;

/// Directions of a hemisphere, evenly distributed by that law, with `rings` directions in each ring.
class HemisphereRays {
  public:
    /// `patterns`: the number of sets, which together form one finer set.
    HemisphereRays(int rings, int patterns) : rings_(rings), patterns_(patterns) {}

    /// `dirt_depth`: D above. `add_reflected`: null: not needed.
    Hemisphere gather(const Point& point, const Point& normal, int pattern, double dirt_depth, const Tracer& tracer,
                      const AddLight& add_reflected) const;

  private:
    int rings_, patterns_;
};

}  // namespace oblong::map
