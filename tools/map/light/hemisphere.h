#pragma once

#include <functional>

#include "tools/map/light/tracer.h"

namespace oblong::map {

/// What is seen from a point of a surface over its hemisphere, each direction counted by the cosine of its angle to the
/// normal (Lambert's law): a mean over rays.
struct Hemisphere {
    double sky_above = 0, sky_below = 0;  ///< the shares in which sky is seen, above the horizon and below
    double shut = 0;                      ///< 0: open, 1: shut in: of a hit at distance d nearer than D, 1 - d / D
    double light = 0;                     ///< the mean light of the surfaces that are seen
};

/// Directions of a hemisphere, spread evenly by that law: as many around as there are rings.
class HemisphereRays {
  public:
    /// `patterns`: how many sets there are, which together are as one finer set.
    HemisphereRays(int rings, int patterns) : rings_(rings), patterns_(patterns) {}

    /// `dirt_depth`: D above. `light_at` gives a surface's light at a point of it, which the ray that leads to it hit;
    /// null: none is asked for.
    Hemisphere gather(const Point& point, const Point& normal, int pattern, double dirt_depth, const Tracer& tracer,
                      const std::function<double(const Point&, const RayHit&, const Point&)>& light_at) const;

  private:
    int rings_, patterns_;
};

}  // namespace oblong::map
