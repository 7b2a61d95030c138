#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "engine/level/level.h"
#include "engine/view/texture_gradients.h"

namespace oblong {

struct FrameContext;
struct TornSpan;
struct ViewScratch;

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
/// suitable. As a search walks the tree, results are kept in `kept`. In continued_face.cpp.
FaceIndex continued_face(const WallHit& hit, bool is_back, const Level& level, ContinuedFaces& kept);

/// Finds what is behind pixels that no face covers, in a frame from the open, with the tree, which is complete even if
/// faces are missing. If a ray through the pixel enters a solid leaf, the texture and the light of the nearest face are
/// continued on the node's plane where it enters (`claims.torn`). If it enters a sky leaf, the sky owns the pixel. If
/// it never leaves the open, the pixel is void, colour 0 (`claims.void_spans`).
void claim_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// Draws these pixels with a division each, regardless of the dials, as they are few.
void draw_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of the wall shown by a torn span.
PlaneInverseZ inverse_z_of(const TornSpan& torn, const FrameContext& frame);

}  // namespace oblong
