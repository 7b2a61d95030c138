#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "engine/level/level.h"

namespace oblong {

/// Where a ray leaves the open: from `from` through the plane of `node`.
struct OpenEnd {
    LeafIndex from = LeafIndex::none();
    NodeIndex node = NodeIndex::none();  ///< none: it never does
    bool is_sky = false;
    Vec3<World> place;

    bool is_same_wall(const OpenEnd& other) const {
        return from == other.from && node == other.node && is_sky == other.is_sky;
    }
};

/// Results of earlier searches, by leaf and node.
using ContinuedFaces = std::map<std::pair<std::int32_t, std::int32_t>, FaceIndex>;

/// The face whose texture is continued on a wall without a face: among faces on this side of the wall's plane, the
/// nearest to the open leaf in front, unless a face on another plane is nearer by 256 units. None if no face is
/// suitable. As a search walks the tree, results are kept in `kept`.
FaceIndex continued_face(const OpenEnd& end, bool is_back, const Level& level, ContinuedFaces& kept);

}  // namespace oblong
