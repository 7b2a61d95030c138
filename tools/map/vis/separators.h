#pragma once

#include <vector>

#include "tools/map/source/geometry.h"

namespace oblong::map {

/// The planes through an edge of one polygon and a corner of the other that have the source on one side and the pass on
/// the other, into `planes`. All points visible from a point of `source` through `pass` are in front of all of them.
void find_separators(const Winding& source, const Winding& pass, std::vector<Plane>& planes);

/// Cuts polygons in place; reuses its memory, as visible sets need millions of cuts.
class SightCutter {
  public:
    /// Keeps the part in front of the plane; a polygon on the plane becomes empty.
    void cut_to_front(Winding& winding, const Plane& plane);

  private:
    void keep_front(const Winding& winding);

    std::vector<double> heights_;  // 0: on the plane
    Winding kept_;
};

}  // namespace oblong::map
