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
/// Adds a face that is in work.polygon and work.rows. `corners` are its own, in the world.
void add_scanned_face(const VisibleFace& visible, std::span<const Vec3<World>> corners, const FrameContext& frame,
                      FrameWorkspace& work);
/// Finds by the settings' method which of the faces added owns each pixel, and claims it for it. What has no owner
/// stays free in the span buffer.
void claim_owned(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
