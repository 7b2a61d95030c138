#pragma once

#include <vector>

#include "engine/frame/surface_pass.h"
#include "engine/view/view_context.h"
#include "tools/bench/bench_level.h"

namespace oblong {

/// A face of a frame that owns pixels, as texturing takes it, without a cutting.
struct TexturedInput {
    std::vector<Span> spans;
    TexturedFace face;
};

/// What each stage of one frame works on. Of the faces, those of the world alone: doors and lifts are left out.
struct StageInputs {
    ViewContext view;
    LeafIndex leaf;                                   ///< of the eye
    std::vector<FaceIndex> visited;                   ///< what the walk returned
    std::vector<std::vector<ScreenVertex>> polygons;  ///< of those that are in view
    std::vector<ScanlineExtents> rows;                ///< of those
    std::vector<TexturedInput> walls;                 ///< those that own pixels and are drawn from a surface
    std::int64_t pixels = 0;                          ///< of the walls
};

/// The frame of a camera, taken apart. The walls' texels are in `work`.
StageInputs collect_stage_inputs(const BenchLevel& level, const Camera& camera, const ScreenMode& mode,
                                 FrameWorkspace& work);

}  // namespace oblong
