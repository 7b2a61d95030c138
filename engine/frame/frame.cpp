#include "engine/frame/frame.h"

#include "engine/frame/draw_view.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/frame_light.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/workspace.h"
#include "engine/view/views.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// The settings without effects that are undefined in this view: a parallel view has neither 1/z, which gives the depth
/// of things, nor an eye, from which fog and water are measured. Mirrors in it are walls.
Settings settings_in(const ViewSpec& view, Settings settings) {
    if (!view.is_parallel) return settings;
    for (const Effect effect :
         {Effect::Particles, Effect::Sprites, Effect::Meshes, Effect::Fog, Effect::Underwater, Effect::Mirror})
        settings.allowed_effects = settings.allowed_effects.without(effect);
    return settings;
}

std::vector<WalkLimit> limits_of(const ViewSpec& view) {
    std::vector<WalkLimit> limits;
    for (const ViewCut& cut : view.cuts)
        limits.push_back({{.normal = cut.normal, .distance = cut.distance}, false, {}});
    return limits;
}

/// The eye, moved clear of planes, and the leaf that decides what is visible: its own or, for a parallel view or one
/// with cuts, whose rays may begin in any leaf, kSolidOutside, from where everything is visible.
PlacedEye place_viewer(const Level& level, const ViewSpec& view) {
    if (view.is_parallel) return {view.eye, kSolidOutside};
    const PlacedEye eye = place_eye(level, view.eye);
    return {eye.position, view.cuts.empty() ? eye.leaf : kSolidOutside};
}

FrameContext make_context(const Scene& scene, const ViewSpec& spec, const ScreenMode& mode, const Settings& settings,
                          FrameWorkspace& work, Framebuffer out) {
    const Accuracy& accuracy = settings.accuracy;
    const ViewContext view = make_view_context(
        spec, mode, {accuracy.matrix_bits, accuracy.view_bits, accuracy.subpixel_bits, settings.correct_aspect});
    FrameContext frame{.scene = scene,
                       .settings = settings,
                       .cache = work.cache,
                       .observers = work.observers,
                       .view = view,
                       .inverse_projection = make_inverse_projection(view.projection, spec.shear_x, spec.shear_y),
                       .texturing = make_span_texturing(accuracy, *settings.kernels),
                       .out = out,
                       .limits = limits_of(spec),
                       .claimer = work.claimer};
    frame.fog = make_frame_fog(frame);
    const bool needs_one_thread = frame.observers.counts || frame.observers.record;
    if (!needs_one_thread) frame.shared = work.shared.get();
    return frame;
}

void start_observers(const FrameWorkspace& work, Framebuffer out) {
    const FrameObservers& observers = work.observers;
    if (observers.counts) {
        *observers.counts = make_frame_counts(out);
        observers.counts->stages.lit_texels =
            -work.cache.surfaces.built_texels();  // end_observers() adds the final count
    }
    if (observers.record) observers.record->pixels.assign(pixel_count(out.pitch, out.height_px), {});
    if (observers.times) *observers.times = {observers.times->clock, observers.times->samples_asked};
}

void end_observers(const FrameWorkspace& work) {
    FrameCounts* const counts = work.observers.counts;
    if (!counts) return;
    counts->stages.lit_texels += work.cache.surfaces.built_texels();
    if (work.cache.surfaces.colour_cube()) counts->stages.coloured_texels = counts->stages.lit_texels;
}

/// Other threads draw from here on: walls as soon as they are claimed, if their light is already known.
void start_sharing(const FrameContext& frame, ViewScratch& scratch) {
    const bool is_light_known = find_light_beforehand(frame, scratch);
    frame.shared->begin(frame, is_light_known);
}

/// Whether the underwater effect applies in a leaf.
bool is_under_liquid(const FrameContext& frame, LeafIndex leaf) {
    const std::int32_t contents = frame.scene.level.leaves[leaf].contents;
    return contents <= contents::kWater && contents >= contents::kLava && frame.allows(Effect::Underwater);
}

}  // namespace

void draw_frame(const Scene& scene, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    start_observers(work, out);
    const PlacedEye eye = place_viewer(scene.level, view);
    ViewSpec placed = view;
    placed.eye = eye.position;
    const Settings in_view = settings_in(view, settings);
    const FrameContext frame = make_context(scene, placed, mode, in_view, work, out);

    work.cache.surfaces.start_frame(settings.accuracy, settings.brightness_100, scene.colormap, *settings.kernels);
    start_view(frame, eye.leaf, work.view);
    work.view.claiming->span_buffer.reset();
    EffectSet& effects = work.view.claims.effects;
    if (is_under_liquid(frame, eye.leaf)) effects = effects.with(Effect::Underwater);
    if (frame.shared) start_sharing(frame, work.view);
    work.plan = draw_view(frame, work.view);
    end_observers(work);
}

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    draw_frame(scene, first_person_view(camera, settings.accuracy.sine), mode, settings, work, out);
}

}  // namespace oblong
