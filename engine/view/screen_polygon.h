#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "engine/base/scratch.h"
#include "engine/view/clip.h"
#include "engine/view/vertex_cache.h"

namespace oblong {

/// A transformed, clipped and projected polygon, with scratch.
struct ScreenPolygon {
    std::span<const ScreenVertex> vertices;
    bool is_clipped = false;  ///< some of its corners are not from the vertex cache

    PolygonClipper clipper;
    Scratch<ClipVertex> own;          ///< corners that are not from the vertex cache
    Scratch<ScreenVertex> projected;  ///< the storage of `vertices`

    /// The nearest and the farthest z of the part in view.
    std::pair<View, View> z_range() const;
};

/// Transforms, clips and projects a face of the level, given its vertices' indices, clockwise seen from its front.
/// False if it is outside the view.
bool project_face(std::span<const VertexIndex> corner_indices, const ViewContext& view, VertexCache& vertices,
                  ScreenPolygon& polygon);

/// The same for any polygon in the world.
bool project_polygon(std::span<const Vec3<World>> corners, const ViewContext& view, ScreenPolygon& polygon);

}  // namespace oblong
