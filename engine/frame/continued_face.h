#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "engine/level/level.h"

namespace oblong {

/// Where a ray from the open enters a solid or sky leaf: out of `open_leaf`, through the plane of `node`.
struct WallHit {
    LeafIndex open_leaf = LeafIndex::none();
    NodeIndex node = NodeIndex::none();  ///< none: it never does
    bool is_sky = false;
    Vec3<World> place;

    bool is_same_wall(const WallHit& other) const {
        return open_leaf == other.open_leaf && node == other.node && is_sky == other.is_sky;
    }
};

/// Results of earlier searches, by leaf and node.
using ContinuedFaces = std::map<std::pair<std::int32_t, std::int32_t>, FaceIndex>;

/// The face whose texture is continued on a wall without a face: among faces on this side of the wall's plane, the
/// nearest to the open leaf in front, unless a face on another plane is nearer by 256 units. None if no face is
/// suitable. As a search walks the tree, results are kept in `kept`.
FaceIndex continued_face(const WallHit& hit, bool is_back, const Level& level, ContinuedFaces& kept);

}  // namespace oblong
