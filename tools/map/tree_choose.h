#pragma once

#include "tools/map/csg.h"

namespace oblong::map {

enum class Side { kOn, kFront, kBack, kBoth };

/// Where a piece lies. The piece's own plane is always kOn.
Side side_of(const BoundaryPiece& piece, int plane_index, const PlaneList& planes);

bool has_only_detail(const std::vector<BoundaryPiece>& pieces);

/// The plane to cut these pieces by: one of theirs.
int choose_plane(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes);

}  // namespace oblong::map
