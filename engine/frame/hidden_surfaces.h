#pragma once

#include <span>
#include <vector>

#include "engine/visibility/ray_casting.h"

namespace oblong {

struct FrameContext;
class FrameWorkspace;

/// What frames without the span buffer work with; `scanned` and `owners` are those of the frame drawn last.
struct HiddenSurfaceScratch {
    ScannedFaces scanned;
    PixelOwners owners;
    std::vector<InverseZ> depths;  ///< of the z-buffer: of each pixel's owner
    RayTargets targets;
};

/// No face is scanned yet.
void start_scanned_faces(FrameWorkspace& work);
/// Adds a face that is in work.polygon and work.rows, for find_pixel_owners(). `corners` are its own, in the world.
void add_scanned_face(const VisibleFace& visible, bool is_seen_through, std::span<const Vec3<World>> corners,
                      const FrameContext& frame, FrameWorkspace& work);
/// Finds which of the faces added owns each pixel, by the settings' method.
void find_pixel_owners(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
