#pragma once

#include "tools/map/brush.h"

namespace oblong::map {

/// A convex piece of the boundary between different contents: what a tree has to separate.
struct BoundaryPiece {
    PlaneSide plane;
    Winding winding;
    Box box;
    bool is_detail = false;  ///< cut by it only when nothing else is left
};

/// The sides of the brushes without what lies within other brushes: the outline of their union, roughly. Where two
/// brushes fill the same space, the contents of higher rank stay, and of equal ones the later brush.
std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes);

/// `winding` without its part inside `brush` or on its surface, in convex pieces; unless nothing is inside, the
/// pieces are new.
std::vector<Winding> outside_of(const Winding& winding, const Brush& brush, const PlaneList& planes);

}  // namespace oblong::map
