#pragma once

#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/frame.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/level_cache.h"
#include "engine/frame/observers.h"
#include "engine/frame/surface_pass.h"
#include "engine/view/texture_gradients.h"
#include "engine/view/view_context.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

class FaceClaimer;
class SharedDrawing;
struct MirrorView;

/// Everything that is constant while one view is drawn: the frame's own, or that of a mirror in it. What changes is the
/// view's ViewScratch, and what is kept from frame to frame the LevelCache.
struct FrameContext {
    const Scene& scene;
    const Settings& settings;
    LevelCache& cache;
    FrameObservers observers;
    ViewContext view;
    InverseProjection inverse_projection;
    SpanTexturing texturing;
    Framebuffer out;
    std::vector<WalkLimit> limits;  ///< parts of the level beyond them are left out
    FrameFog fog = {};
    const MirrorView* mirror = nullptr;  ///< the one whose picture the view is; null: the frame's own view
    SharedDrawing* shared = nullptr;     ///< hands spans to other threads; null: one thread draws
    FaceClaimer* claimer = nullptr;      ///< FrameWorkspace::claimer

    const Accuracy& accuracy() const { return settings.accuracy; }
    bool allows(Effect effect) const { return settings.allowed_effects.has(effect); }
    /// How far a face's model has moved.
    Vec3<World> offset_of(const VisibleFace& face) const { return cache.brush_models.offset_of(face.fragment); }
};

// In frame.cpp: what draw_frame() does with its own view, for a mirror to do with another one.

/// Starts to draw a view from a leaf: what may be seen from there, and nothing claimed yet.
void start_view(const FrameContext& frame, LeafIndex leaf, ViewScratch& scratch);

/// Draws a view that was started: lets faces claim the pixels that are free in its span buffer, makes a plan of what
/// was claimed, and runs it. Returns the plan.
FramePlan draw_view(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
