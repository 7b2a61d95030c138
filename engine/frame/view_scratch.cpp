#include "engine/frame/view_scratch.h"

#include <utility>

#include "engine/base/table.h"

namespace oblong {

ClaimScratch::ClaimScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode)
    : vertices(level.vertices), rows(mode.height_px), span_buffer(mode.width_px, mode.height_px) {
    walk.face_marks.resize(level.faces.size());
    walk.entered = LeafSet(level.leaves.size());
    walk.steps.reserve(level.nodes.size());
    polygon.clipper.reserve(faces.most_corners + kClipPlaneCount);
    polygon.projected.take(faces.most_corners + kClipPlaneCount);
}

ViewScratch::ViewScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode,
                         std::shared_ptr<ClaimScratch> shared)
    : visible(level),
      claiming(shared ? std::move(shared) : std::make_shared<ClaimScratch>(level, faces, mode)),
      depth(mode.width_px, mode.height_px),
      surfaces(mode.width_px),
      effects(mode.height_px) {
    claims.spans.room_for(as_size(mode.height_px) * 16);
}

ViewScratch::~ViewScratch() = default;

}  // namespace oblong
