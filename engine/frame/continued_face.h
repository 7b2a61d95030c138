#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "engine/level/level.h"

namespace oblong {

/// Where a ray leaves the open: from a leaf, through a node's plane.
struct OpenEnd {
    LeafIndex from = LeafIndex::none();
    NodeIndex node = NodeIndex::none();  ///< none: it does not
    bool is_sky = false;
    Vec3<World> place;

    bool is_same_wall(const OpenEnd& other) const {
        return from == other.from && node == other.node && is_sky == other.is_sky;
    }
};

/// Faces that were searched for before, by leaf and node.
using ContinuedFaces = std::map<std::pair<std::int32_t, std::int32_t>, FaceIndex>;

/// The face whose texture goes on where a wall has none: of those on the wall's plane, of which it shows this side, the
/// nearest to the open before it, unless one on another plane is nearer by 256 units. None: no face will do. A search
/// looks through the tree, so that what it finds is kept.
FaceIndex continued_face(const OpenEnd& end, bool is_back, const Level& level, ContinuedFaces& kept);

}  // namespace oblong
