#pragma once

#include "tools/map/tree/tree.h"

namespace oblong::map {

/// The sides of the brushes without the parts inside other brushes: the boundary of their union, roughly. Where two
/// brushes fill the same space, the contents of higher rank remain, and of equal ranks the later brush.
std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes);

}  // namespace oblong::map
