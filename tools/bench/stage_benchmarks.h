#pragma once

#include <vector>

#include "engine/frame/surface_pass.h"
#include "engine/view/view_context.h"
#include "tools/bench/bench_level.h"

namespace oblong {

/// A face that owns pixels of a frame, as input for texturing, without a cutting.
struct TexturedInput {
    std::vector<Span> spans;
    TexturedFace face;
};

/// The input of each stage of a frame; only of the world's faces, without doors and lifts.
struct StageInputs {
    ViewContext view;
    LeafIndex leaf;                                   ///< of the eye
    std::vector<FaceIndex> visited;                   ///< returned by the walk
    std::vector<std::vector<ScreenVertex>> polygons;  ///< of the visited faces in view
    std::vector<ScanlineExtents> rows;                ///< of the polygons
    std::vector<TexturedInput> walls;                 ///< the faces that own pixels and have a surface
    std::int64_t pixels = 0;                          ///< of the walls
};

/// The stages' inputs for a camera's frame. The walls' texels are in `work`.
StageInputs collect_stage_inputs(const BenchLevel& level, const Camera& camera, const ScreenMode& mode,
                                 FrameWorkspace& work);

}  // namespace oblong
