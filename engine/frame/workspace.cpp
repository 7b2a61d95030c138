#include "engine/frame/workspace.h"

#include "engine/base/table.h"
#include "engine/base/workers.h"
#include "engine/frame/shared_drawing.h"

namespace oblong {

ClaimScratch::ClaimScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode)
    : vertices(level.vertices), rows(mode.height_px), span_buffer(mode.width_px, mode.height_px) {
    walk.face_marks.resize(level.faces.size());
    walk.entered = LeafSet(level.leaves.size());
    polygon.clipper.reserve(faces.most_corners + kClipPlaneCount);
    polygon.projected.take(faces.most_corners + kClipPlaneCount);
}

ViewScratch::ViewScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode)
    : visible(level),
      depth(mode.width_px, mode.height_px),
      claiming(std::make_shared<ClaimScratch>(level, faces, mode)),
      surfaces(std::make_shared<SurfaceScratch>(mode.width_px)),
      effects(std::make_shared<EffectScratch>(mode.height_px)) {
    claims.spans.room_for(as_size(mode.height_px) * 16);
}

ViewScratch::ViewScratch(const ViewScratch& outer, const ScreenMode& mode)
    : visible(outer.visible),
      depth(mode.width_px, mode.height_px),
      claiming(outer.claiming),
      surfaces(outer.surfaces),
      effects(outer.effects) {}

FrameWorkspace::FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers)
    : cache(level, mode), view(level, cache.faces, mode) {
    if (workers && workers->count() > 1) shared = std::make_unique<SharedDrawing>(*workers, mode.width_px);
}

FrameWorkspace::~FrameWorkspace() = default;

}  // namespace oblong
