#include "engine/frame/draw_view.h"

#include "engine/frame/claim_faces.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/frame_light.h"
#include "engine/frame/frame_things.h"
#include "engine/frame/mirror_pass.h"
#include "engine/frame/passes.h"
#include "engine/frame/thing_pass.h"
#include "engine/frame/torn_pixels.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

/// Finds the face that owns each pixel.
void claim_pixels(const FrameContext& frame, ViewScratch& scratch) {
    const Stopwatch watch(frame.observers.times, &PassTimes::claims_ns);
    if (frame.claimer)
        frame.claimer->claim(frame, scratch);
    else
        claim_faces(frame, scratch);
    if (!scratch.claiming->span_buffer.is_full()) claim_torn_pixels(frame, scratch);
    if (!scratch.claims.list(FaceList::Mirror).empty()) limit_mirrors(frame, scratch.claims);
}

}  // namespace

void start_view(const FrameContext& frame, LeafIndex leaf, ViewScratch& scratch) {
    const Scene& scene = frame.scene;
    scratch.visible.see_from(scene.level, leaf);
    scratch.claiming->vertices.start_frame();
    scratch.claims.clear();
    const Stopwatch watch(frame.observers.times, Effect::BrushModels);
    frame.cache.brush_models.start_frame(scene.level, scene.models, frame.cache.faces);
}

FramePlan draw_view(const FrameContext& frame, ViewScratch& scratch) {
    claim_pixels(frame, scratch);
    find_things(frame, scratch);
    find_fog(frame, scratch);
    find_light(frame, scratch);
    FramePlan plan = plan_frame(scratch.claims);
    run_passes(plan, frame, scratch);
    plan.effects = scratch.claims.effects;
    return plan;
}

}  // namespace oblong
