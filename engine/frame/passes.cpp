#include "engine/frame/passes.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/effects/sky.h"
#include "engine/effects/warp.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/frame_things.h"
#include "engine/frame/mesh_pass.h"
#include "engine/frame/mirror_pass.h"
#include "engine/frame/see_through_pass.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/thing_pass.h"
#include "engine/frame/torn_pixels.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

template <FaceList List>
bool has_faces(const Claims& claims) {
    return !claims.list(List).empty();
}

template <FaceList List>
std::int64_t pixels_of_faces(const Claims& claims, const FrameCounts&) {
    return pixels_of(claims, List);
}

template <Effect Of>
std::int64_t pixels_of_effect(const Claims&, const FrameCounts& counts) {
    return counts.of(Of);
}

bool has_uncovered(const Claims& claims) {
    return !claims.torn.empty() || !claims.void_spans.empty();
}

std::int64_t uncovered_pixels(const Claims& claims, const FrameCounts&) {
    std::int64_t pixels = pixels_of(claims.void_spans);
    for (const TornSpan& torn : claims.torn) pixels += torn.span.end - torn.span.first;
    return pixels;
}

std::int64_t fog_pixels(const Claims& claims, const FrameCounts&) {
    return pixels_of(claims.fog_runs);
}

bool has_seen_through(const Claims& claims) {
    return !claims.list(FaceList::SeeThrough).empty() || !claims.things.visible.empty();
}

std::int64_t seen_through_pixels(const Claims& claims, const FrameCounts& counts) {
    return pixels_of(claims, FaceList::SeeThrough) + counts.of(Effect::Particles) + counts.of(Effect::Sprites);
}

/// Fills faces, whose effect is not allowed, with one colour of their texture.
void draw_flat(const FrameContext& frame, ViewScratch& scratch) {
    const Level& level = frame.scene.level;
    for (const VisibleFace& claimed : scratch.claims.list(FaceList::Flat)) {
        const std::span<const Span> spans = scratch.claims.spans_of(claimed);
        observe_spans(claimed, spans, frame.out, frame.observers);
        fill_spans(spans, level.texture_of(level.faces[claimed.face]).mips[3][0], frame.out);
    }
}

void draw_liquids(const FrameContext& frame, ViewScratch& scratch) {
    SurfaceOptions options;
    options.is_plain = false;
    options.traits.warps = true;
    draw_surfaces(scratch.claims.list(FaceList::Liquid), options, frame, scratch);
}

void draw_sky_faces(const FrameContext& frame, ViewScratch& scratch) {
    std::vector<Span>& all = scratch.effects->sky_spans;
    all.clear();
    for (const VisibleFace& claimed : scratch.claims.list(FaceList::Sky)) {
        const std::span<const Span> spans = scratch.claims.spans_of(claimed);
        observe_spans(claimed, spans, frame.out, frame.observers);
        all.insert(all.end(), spans.begin(), spans.end());
    }
    const Level& level = frame.scene.level;
    const MipTexture& texture = level.textures[level.sky];
    if (!is_layered_sky(texture.width, texture.height)) return fill_spans(all, texture.mips[0][0], frame.out);
    const SkyNow sky = compose_sky({texture.mips[0].data(), texture.height, texture.width}, frame.scene.time_ms,
                                   pixels_of(all), frame.cache.sky_layers);
    if (is_shared(frame)) return frame.shared->add_sky(sky, all);
    const std::int64_t blocks = draw_sky(all, sky, frame.view.ray_directions(), frame.view.projection, frame.out,
                                         frame.settings.kernels->draw_blocks);
    if (frame.observers.counts) count_sky(all, blocks, sky, frame.observers.counts->stages);
}

void draw_fog_runs(const FrameContext& frame, ViewScratch& scratch) {
    draw_fog(scratch.claims.fog_runs, frame.fog.tables->colours_of(scratch.claims.fog_runs), frame.out);
}

void draw_waves(const FrameContext& frame, ViewScratch& scratch) {
    if (frame.observers.counts)
        frame.observers.counts->of(Effect::Underwater) = std::int64_t{frame.out.width_px} * frame.out.height_px;
    draw_underwater(frame.scene.time_ms, scratch.effects->underwater, frame.out);
}

void end_sharing(const FrameContext& frame) {
    if (frame.shared) frame.shared->end();
}

}  // namespace

const std::array<Pass, kPassCount> kPasses{{
    {"walls", true, has_faces<FaceList::Walls>, pixels_of_faces<FaceList::Walls>, draw_walls},
    {"flat", true, has_faces<FaceList::Flat>, pixels_of_faces<FaceList::Flat>, draw_flat},
    {"liquid", true, has_faces<FaceList::Liquid>, pixels_of_faces<FaceList::Liquid>, draw_liquids},
    {"sky", true, has_faces<FaceList::Sky>, pixels_of_faces<FaceList::Sky>, draw_sky_faces},
    {"mirror", true, has_faces<FaceList::Mirror>, pixels_of_faces<FaceList::Mirror>, draw_mirrors},
    {"uncovered", true, has_uncovered, uncovered_pixels, draw_torn_pixels},
    {"shadows", false, [](const Claims& claims) { return !claims.things.shadows.empty(); },
     pixels_of_effect<Effect::Shadows>, draw_shadows},
    {"fog", false, [](const Claims& claims) { return !claims.fog_runs.empty(); }, fog_pixels, draw_fog_runs},
    {"models", false, [](const Claims& claims) { return !claims.things.meshes.empty(); },
     pixels_of_effect<Effect::Meshes>, draw_meshes},
    {"see_through", false, has_seen_through, seen_through_pixels, draw_see_through},
    {"underwater", false, [](const Claims& claims) { return claims.effects.has(Effect::Underwater); },
     pixels_of_effect<Effect::Underwater>, draw_waves},
}};

std::size_t pass_of(Effect effect) {
    const auto pass = std::find_if(kPasses.begin(), kPasses.end(),
                                   [effect](const Pass& one) { return one.name == item(kEffectNames, effect); });
    return as_size(pass - kPasses.begin());
}

FramePlan plan_frame(const Claims& claims) {
    FramePlan plan;
    for (std::size_t i = 0; i < kPassCount; ++i) plan.passes[i] = kPasses[i].has_work(claims);
    return plan;
}

void run_passes(const FramePlan& plan, const FrameContext& frame, ViewScratch& scratch) {
    for (std::size_t i = 0; i < kPassCount; ++i) {
        if (!plan.passes[i]) continue;
        if (!kPasses[i].owns_pixels) end_sharing(frame);
        const Stopwatch watch(frame.observers.times, i);
        kPasses[i].run(frame, scratch);
    }
    end_sharing(frame);
    FrameCounts* const counts = frame.observers.counts;
    if (!counts) return;
    for (std::size_t i = 0; i < kPassCount; ++i) counts->pass_pixels[i] = kPasses[i].pixels(scratch.claims, *counts);
    for (std::size_t i = 0; i < kEffectCount; ++i) counts->effect_pixels[i] += counts->mirrored_pixels[i];
}

}  // namespace oblong
