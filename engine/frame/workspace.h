#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/effects/sky.h"
#include "engine/effects/things.h"
#include "engine/effects/underwater.h"
#include "engine/effects/warp.h"
#include "engine/frame/claims.h"
#include "engine/frame/fog_pass.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/hidden_surfaces.h"
#include "engine/frame/mirror_pass.h"
#include "engine/frame/pass_times.h"
#include "engine/frame/plan.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/texture_spans.h"
#include "engine/mesh/draw_mesh.h"
#include "engine/raster/scan.h"
#include "engine/scene/face_surface.h"
#include "engine/scene/face_table.h"
#include "engine/scene/level_effects.h"
#include "engine/view/screen.h"
#include "engine/view/screen_polygon.h"
#include "engine/visibility/brush_models.h"
#include "engine/visibility/front_to_back.h"
#include "engine/visibility/span_buffer.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

/// The scratch and the caches of frames of one level with one colormap in one mode. Nothing in it is part of a picture:
/// a fresh workspace draws the same bytes. The level must outlive it.
class FrameWorkspace {
  public:
    /// `workers` outlive it, and share in the drawing of its frames; null: one thread draws.
    FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers = nullptr);
    FrameWorkspace(const FrameWorkspace&) = delete;  // its parts refer to each other

    FaceTable faces;
    VertexCache vertices;
    VisibleSet visible;
    WalkScratch walk;
    SpanBuffer span_buffer;
    std::vector<VertexIndex> own_corners;  ///< of the current face, without those at T-junctions
    ScreenPolygon polygon;
    ScanlineExtents rows;
    Claims claims;                            ///< of the frame's faces
    std::array<std::vector<Span>, 4> of_mip;  ///< the current face's spans that each mip level draws
    std::vector<Span> pass_spans;             ///< all of the current pass, where it draws them together
    SpanScratch span_scratch;
    FaceSurfaces surfaces;
    BrushModels brush_models;

    std::map<std::pair<std::int32_t, std::int32_t>, FaceIndex> continued_faces;  ///< of torn walls, by leaf and node

    LevelEffects effects;                               ///< what the level calls for
    Things things;                                      ///< what is in it beside its faces
    LightStyles light_styles{};                         ///< of the frame
    std::vector<MovingLight> lights;                    ///< of the frame
    DepthBuffer depth;                                  ///< around the things in view
    ShadowScratch shadows;                              ///< untouched without shadows
    std::unique_ptr<MeshScratch> meshes;                ///< null until a frame shows one
    std::vector<MovingLight> mesh_lights;               ///< those that reach the current one
    std::unique_ptr<LevelFogTables> fog_tables;         ///< null until a frame shows fog
    std::array<std::unique_ptr<BlendTable>, 4> blends;  ///< by LiquidKind; null until a frame sees through one
    std::vector<FogRun> thing_runs;                     ///< scratch of the fog on a thing
    WarpTables warp{};                                  ///< of liquids
    std::int64_t warp_time_ms = -1;                     ///< the time of `warp`
    std::vector<std::uint8_t> sky_layers;               ///< both layers of the sky as one
    UnderwaterScratch underwater;
    MirrorScratch mirror;
    std::unique_ptr<HiddenSurfaceScratch> hidden_surfaces;  ///< null until a frame goes without the span buffer

    FramePlan plan;                         ///< of the frame drawn last
    std::unique_ptr<SharedDrawing> shared;  ///< null: one thread draws
    std::unique_ptr<FrameCounts> counts;    ///< null: nothing is counted
    std::unique_ptr<FrameRecord> record;    ///< null: nothing is recorded
    std::unique_ptr<PassTimes> times;       ///< null: nothing is timed
};

}  // namespace oblong
