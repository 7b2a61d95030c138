#include "engine/frame/workspace.h"

#include <algorithm>

namespace oblong {

FrameWorkspace::FrameWorkspace(const Level& level, const ScreenMode& mode)
    : faces(make_face_table(level)),
      vertices(level.vertices),
      visible(level),
      span_buffer(mode.width_px, mode.height_px),
      rows(mode.height_px),
      blocks(mode.width_px),
      surfaces(level, faces, mode.width_px),
      brush_models(level) {
    walk.face_marks.resize(level.faces.size());
    walk.steps.reserve(level.nodes.size());
    claims.spans.reserve(static_cast<std::size_t>(mode.height_px) * 16);
    polygon.corners.reserve(faces.most_corners);
    polygon.screen.reserve(faces.most_corners + kClipPlaneCount);
    polygon.clip.polygon.reserve(faces.most_corners + kClipPlaneCount);
    polygon.clip.other.reserve(faces.most_corners + kClipPlaneCount);
}

}  // namespace oblong
