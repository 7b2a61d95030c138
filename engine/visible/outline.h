#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/clip.h"
#include "engine/raster/scan.h"
#include "engine/visible/coverage.h"
#include "engine/visible/vertex_cache.h"

namespace oblong {

/// A polygon on its way to the screen, and the scratch that it needs.
struct Outline {
    std::vector<CachedVertex*> corners;
    ClipScratch clip;
    std::vector<ScreenVertex> screen;
    std::int64_t nearest_z_16 = 0;  ///< of what is in view
};

/// The outline of a face of the level, from its vertices' indices, clockwise seen from its front: transform, clip,
/// project. False if nothing of it is in view.
bool make_face_outline(std::span<const std::int32_t> corner_indices, const ViewContext& view, VertexCache& vertices,
                       Outline& outline);

/// The same of any polygon in the world.
bool make_polygon_outline(std::span<const Vec3<World>> corners, const ViewContext& view, Outline& outline);

/// Claims the pixels of an outline that are still free, appended to `owned`.
void claim_outline(const Outline& outline, RowColumns& rows, Coverage& coverage, std::vector<Span>& owned);

}  // namespace oblong
