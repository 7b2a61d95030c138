#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/effects/shadows.h"
#include "engine/effects/warp.h"
#include "engine/frame/claims.h"
#include "engine/frame/face_cover.h"
#include "engine/frame/frame_plan.h"
#include "engine/frame/level_cache.h"
#include "engine/frame/mirror_view.h"
#include "engine/frame/observers.h"
#include "engine/frame/span_texturing.h"
#include "engine/mesh/draw_mesh.h"
#include "engine/raster/depth.h"
#include "engine/raster/scan.h"
#include "engine/scene/light_styles.h"
#include "engine/scene/moving_lights.h"
#include "engine/view/screen_polygon.h"
#include "engine/visibility/front_to_back.h"
#include "engine/visibility/span_buffer.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

class FaceClaimer;
class SharedDrawing;
class Workers;

/// Corners of the current face.
struct CornerScratch {
    std::vector<VertexIndex> own;          ///< without those at T-junctions
    std::vector<Vec3<World>> world;        ///< all, then those of the part within the frame's limits
    std::vector<PlaneDistance> distances;  ///< of `world` from a limit
};

/// The light of a view.
struct FrameLight {
    LightStyles styles{};
    std::vector<MovingLight> moving;  ///< lights that may touch something in view
};

/// Scratch of a view's surfaces.
struct SurfaceScratch {
    explicit SurfaceScratch(std::int32_t longest_px) : spans(longest_px) {}

    std::array<std::vector<Span>, 4> of_mip;  ///< the current face's spans by mip level
    SpanScratch spans;
};

/// Scratch of effects; not used by frames without them.
struct EffectScratch {
    explicit EffectScratch(std::int32_t height_px) : shadows(height_px) {}

    ShadowScratch shadows;
    std::unique_ptr<MeshScratch> meshes;   ///< null until a frame shows a mesh
    std::vector<MovingLight> mesh_lights;  ///< that reach the current mesh
    std::vector<OpenFace> open_faces;      ///< of the current thing
    std::vector<FogRun> fog_runs;          ///< on a thing or on what is seen through
    std::vector<Span> sky_spans;
    std::vector<Span> in_front_spans, fog_level_spans;  ///< of what is seen through: in front of models; in one fog
    UnderwaterScratch underwater;
};

/// Scratch of claiming pixels; not used afterwards.
struct ClaimScratch {
    ClaimScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode);

    WalkScratch walk;
    VertexCache vertices;
    CornerScratch corners;
    ScreenPolygon polygon;  ///< the current face's
    ScanlineExtents rows;   ///< of the polygon
    SpanBuffer span_buffer;
};

/// Scratch for one view of a level in one mode. A mirror's view has another.
struct ViewScratch {
    /// Level and faces must outlive it.
    ViewScratch(const Level& level, const FaceTable& faces, const ScreenMode& mode);
    /// For the view in a mirror, drawn after the `outer` view's pixels are claimed. The two share the scratch that
    /// holds nothing from one stage to the next.
    ViewScratch(const ViewScratch& outer, const ScreenMode& mode);
    ViewScratch(const ViewScratch&) = delete;

    VisibleSet visible;  ///< from the eye's leaf
    Claims claims;       ///< of the view's faces
    ThingsInSet things;  ///< in that set
    DepthBuffer depth;   ///< around the things in view
    FrameLight light;
    MirrorScratch mirror;

    // Shared by a view and the mirrors in it.
    std::shared_ptr<ClaimScratch> claiming;
    std::shared_ptr<SurfaceScratch> surfaces;
    std::shared_ptr<EffectScratch> effects;
};

/// Caches and scratch for frames of one level with one colormap in one mode. They never change a picture.
struct FrameWorkspace {
    /// `level` and `workers` must outlive it. `workers` share the drawing; null: one thread draws.
    FrameWorkspace(const Level& level, const ScreenMode& mode, Workers* workers = nullptr);
    ~FrameWorkspace();

    LevelCache cache;
    ViewScratch view;                       ///< of the eye's view; contains that of mirrors
    std::unique_ptr<SharedDrawing> shared;  ///< null: one thread draws
    FramePlan plan;                         ///< of the last frame
    FrameObservers observers;               ///< of the next frames
    FaceClaimer* claimer = nullptr;         ///< claims pixels; null: claim_faces()
};

}  // namespace oblong
