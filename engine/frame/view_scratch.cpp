#include "engine/frame/view_scratch.h"

#include "engine/base/table.h"

namespace oblong {

ViewScratch::ViewScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode)
    : visible(level),
      vertices(level.vertices),
      rows(mode.height_px),
      span_buffer(mode.width_px, mode.height_px),
      depth(mode.width_px, mode.height_px),
      surfaces(mode.width_px),
      effects(mode.height_px) {
    walk.face_marks.resize(level.faces.size());
    walk.steps.reserve(level.nodes.size());
    claims.spans.room_for(as_size(mode.height_px) * 16);
    polygon.clipper.reserve(faces.most_corners + kClipPlaneCount);
    polygon.projected.take(faces.most_corners + kClipPlaneCount);
}

ViewScratch::~ViewScratch() = default;

}  // namespace oblong
