#pragma once

#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/fog_tables.h"
#include "engine/frame/level_cache.h"
#include "engine/frame/observers.h"
#include "engine/frame/scene.h"
#include "engine/frame/span_texturing.h"
#include "engine/view/texture_gradients.h"
#include "engine/view/view_context.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

class FaceClaimer;
class SharedDrawing;
struct MirrorView;

/// Everything that is constant while one view is drawn, the frame's or a mirror's. ViewScratch holds what changes,
/// LevelCache what is kept from frame to frame.
struct FrameContext {
    const Scene& scene;
    const Settings& settings;
    LevelCache& cache;
    FrameObservers observers;
    ViewContext view;
    InverseProjection inverse_projection;
    SpanTexturing texturing;
    Framebuffer out;
    std::vector<WalkLimit> limits;  ///< the level beyond them is not drawn
    FrameFog fog = {};
    const MirrorView* mirror = nullptr;  ///< the mirror of this view; null: the frame's view
    SharedDrawing* shared = nullptr;     ///< hands spans to other threads; null: one thread draws
    FaceClaimer* claimer = nullptr;      ///< FrameWorkspace::claimer

    const Accuracy& accuracy() const { return settings.accuracy; }
    bool allows(Effect effect) const { return settings.allowed_effects.has(effect); }
    /// The offset of a face's model.
    Vec3<World> offset_of(const VisibleFace& face) const { return cache.brush_models.offset_of(face.fragment); }
};

}  // namespace oblong
