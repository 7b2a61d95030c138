#pragma once

#include <cstdint>
#include <span>

#include "engine/base/scratch.h"
#include "engine/view/clip.h"
#include "engine/view/vertex_cache.h"

namespace oblong {

/// A polygon while it is transformed, clipped and projected, with the scratch for it.
struct ScreenPolygon {
    std::span<const ScreenVertex> screen;
    View nearest_z, farthest_z;  ///< of the part in view
    bool is_clipped = false;     ///< not all of its corners are those of the vertex cache

    PolygonClipper clipper;
    Scratch<ClipVertex> own;          ///< corners of polygons that are not of the vertex cache
    Scratch<ScreenVertex> projected;  ///< where `screen` is
};

/// The polygon of a face of the level, from its vertices' indices, clockwise seen from its front: transform, clip,
/// project. False if nothing of it is in view.
bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon);

/// The same for any polygon in the world.
bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon);

}  // namespace oblong
