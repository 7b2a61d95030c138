#include "engine/frame/passes.h"

#include <algorithm>

#include "engine/effects/sky.h"
#include "engine/effects/warp.h"
#include "engine/frame/fog_pass.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/light_pass.h"
#include "engine/frame/model_pass.h"
#include "engine/frame/see_through_pass.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/torn_pixels.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

/// Fills faces whose effect is not allowed with one colour of their texture.
void draw_flat(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    for (const ClaimedFace& claimed : work.claims.list(FaceList::Flat)) {
        const std::span<const Span> spans = work.claims.spans_of(claimed);
        note_spans(claimed, spans, frame.out, work);
        fill_spans(spans, level.texture_of(level.faces[claimed.visible.face]).mips[3][0], frame.out);
    }
}

void draw_sky_faces(const FrameContext& frame, FrameWorkspace& work) {
    work.pass_spans.clear();
    for (const ClaimedFace& claimed : work.claims.list(FaceList::Sky)) {
        const std::span<const Span> spans = work.claims.spans_of(claimed);
        note_spans(claimed, spans, frame.out, work);
        work.pass_spans.insert(work.pass_spans.end(), spans.begin(), spans.end());
    }
    const Level& level = frame.scene.level;
    const MipTexture& texture = level.textures[level.sky];
    const bool is_layered = texture.width == 2 * texture.height && (texture.height & (texture.height - 1)) == 0;
    if (!is_layered) return fill_spans(work.pass_spans, texture.mips[0][0], frame.out);
    const SkyNow sky = compose_sky({texture.mips[0].data(), texture.height, texture.width}, frame.scene.time_ms,
                                   pixels_of(work.pass_spans), work.sky_layers);
    if (frame.shared) return frame.shared->add_sky(sky, work.pass_spans);
    const std::int64_t blocks =
        draw_sky(work.pass_spans, sky, frame.view.ray_directions(), frame.view.projection, frame.out);
    if (work.counts) count_sky(work.pass_spans, blocks, sky, work.counts->stages);
}

SurfaceDrawing liquid_drawing() {
    SurfaceDrawing drawing;
    drawing.is_plain = false;
    drawing.traits.warps = true;
    return drawing;
}

void end_sharing(const FrameContext& frame) {
    if (frame.shared) frame.shared->end();
}

void run(Pass pass, const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work) {
    const Stopwatch watch(work.times.get(), pass);
    switch (pass) {
        case Pass::Walls:
            return draw_surfaces(FaceList::Walls, {}, frame, work);
        case Pass::Flat:
            return draw_flat(frame, work);
        case Pass::Liquid:
            return draw_surfaces(FaceList::Liquid, liquid_drawing(), frame, work);
        case Pass::Sky:
            return draw_sky_faces(frame, work);
        case Pass::Mirror:
            end_sharing(frame);  // what a mirror shows is drawn by one thread
            return draw_mirrors(frame, work);
        case Pass::Shadows:
            return draw_shadows(frame, work);
        case Pass::Fog:
            return draw_fog(work.claims.fog_runs, fog.tables->colours, frame.out);
        case Pass::Models:
            return draw_meshes(frame, fog, work);
        case Pass::SeeThrough:
            return draw_see_through(frame, fog, work);
        case Pass::Underwater:
            return draw_underwater(frame.scene.time_ms, work.underwater, frame.out);
    }
}

/// Whether the eye is in a liquid: then the whole picture waves, but not those in mirrors.
void find_underwater(const FrameContext& frame, FrameWorkspace& work) {
    const bool is_liquid = frame.eye_contents <= contents::kWater && frame.eye_contents >= contents::kLava;
    work.claims.is_under_liquid = is_liquid && !frame.mirror && frame.allows(Effect::Underwater);
    if (work.claims.is_under_liquid) work.claims.effects = work.claims.effects.with(Effect::Underwater);
}

void count_passes(const Claims& claims, const Framebuffer& out, FrameCounts& counts) {
    counts.of(Pass::Walls) = pixels_of(claims, FaceList::Walls);
    counts.of(Pass::Flat) = pixels_of(claims, FaceList::Flat);
    counts.of(Pass::Liquid) = pixels_of(claims, FaceList::Liquid);
    counts.of(Pass::Sky) = pixels_of(claims, FaceList::Sky);
    counts.of(Pass::Mirror) = pixels_of(claims, FaceList::Mirror);
    counts.of(Pass::Shadows) = counts.of(Effect::Shadows);
    for (const FogRun& run : claims.fog_runs) counts.of(Effect::Fog) += run.span.end - run.span.first;
    counts.of(Pass::Fog) = counts.of(Effect::Fog);
    counts.of(Pass::SeeThrough) =
        pixels_of(claims, FaceList::SeeThrough) + counts.of(Effect::Particles) + counts.of(Effect::Sprites);
    if (!claims.is_under_liquid) return;
    counts.of(Effect::Underwater) = std::int64_t{out.width_px} * out.height_px;
    counts.of(Pass::Underwater) = counts.of(Effect::Underwater);
}

}  // namespace

void note_spans(const ClaimedFace& claimed, std::span<const Span> spans, Framebuffer out, FrameWorkspace& work) {
    if (work.counts) count_writes(spans, out.pitch, *work.counts);
    if (work.record) record_spans(record_of(claimed.visible), spans, out, *work.record);
}

FramePlan draw_view(const FrameContext& frame, FrameWorkspace& work) {
    if (frame.shared) frame.shared->takes_walls_at_once = find_light_beforehand(frame, work);
    claim_faces(frame, work);
    const FrameFog fog = make_frame_fog(frame, work);
    find_things(frame, fog, work);
    find_fog(frame, fog, work);
    find_light(frame, work);
    find_underwater(frame, work);
    FramePlan plan = plan_frame(work.claims);
    if (work.counts) count_passes(work.claims, frame.out, *work.counts);
    const auto first_over_others = std::find_if(plan.passes.begin(), plan.passes.end(), draws_over_others);
    for (auto pass = plan.passes.begin(); pass != first_over_others; ++pass) run(*pass, frame, fog, work);
    end_sharing(frame);
    draw_torn_pixels(frame, work);
    for (auto pass = first_over_others; pass != plan.passes.end(); ++pass) run(*pass, frame, fog, work);
    return plan;
}

}  // namespace oblong
