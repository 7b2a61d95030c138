#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/passes.h"
#include "engine/frame/workspace.h"
#include "engine/view/views.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// What has a meaning in this view. Depth among things and for hidden surfaces is 1/z, fog and the water before the eye
/// are measured from the eye: a parallel view has neither, and is drawn without them; mirrors in it are walls.
Settings settings_in(const ViewSpec& view, Settings settings) {
    if (!view.is_parallel) return settings;
    for (const Effect effect :
         {Effect::Particles, Effect::Sprites, Effect::Models, Effect::Fog, Effect::Underwater, Effect::Mirror})
        settings.allowed_effects = settings.allowed_effects.without(effect);
    settings.hidden_surfaces = HiddenSurfaces::SpanBuffer;
    return settings;
}

std::vector<WalkLimit> limits_of(const ViewSpec& view) {
    std::vector<WalkLimit> limits;
    for (const ViewCut& cut : view.cuts) limits.push_back({{cut.normal, cut.distance}, false, {}});
    return limits;
}

/// The eye, moved clear of planes. The whole level may be seen where the void may: not from where the eye is, but from
/// where its rays begin.
PlacedEye place_viewer(const Level& level, const ViewSpec& view) {
    if (view.is_parallel) return {view.eye, kSolidOutside};
    const PlacedEye eye = place_eye(level, view.eye);
    return {eye.position, view.cuts.empty() ? eye.leaf : kSolidOutside};
}

/// Who draws a frame, if it is more than one thread. What is counted or recorded is drawn by one: in an order.
SharedDrawing* shared_drawing_of(const FrameWorkspace& work) {
    return work.counts || work.record ? nullptr : work.shared.get();
}

/// Finds what may be seen, and starts everything that lasts for a frame.
FrameContext begin_frame(const Scene& scene, ViewSpec spec, const ScreenMode& mode, const Settings& settings,
                         FrameWorkspace& work, Framebuffer out) {
    if (work.times) *work.times = {work.times->clock, work.times->faces_walked};
    const PlacedEye eye = place_viewer(scene.level, spec);
    spec.eye = eye.position;
    work.visible.see_from(scene.level, eye.leaf);
    {
        const Stopwatch watch(work.times.get(), Effect::BrushModels);
        work.brush_models.start_frame(scene.level, scene.models, work.faces);
    }
    work.vertices.start_frame();
    work.surfaces.start_frame(settings.accuracy, settings.brightness_100, scene.colormap);
    work.span_buffer.reset();
    work.claims.clear();
    if (work.counts) *work.counts = make_frame_counts(out);
    if (work.record) work.record->pixels.assign(pixel_count(out.pitch, out.height_px), {});

    const Accuracy& accuracy = settings.accuracy;
    const ViewContext view = make_view_context(
        spec, mode, {accuracy.matrix_bits, accuracy.view_bits, accuracy.subpixel_bits, settings.correct_aspect});
    return {scene,
            settings,
            view,
            make_inverse_projection(view.projection, spec.shear_x, spec.shear_y),
            make_span_texturing(settings.accuracy),
            out,
            scene.level.leaves[eye.leaf].contents,
            nullptr,
            limits_of(spec),
            shared_drawing_of(work)};
}

/// Adds what is known at the end of a frame only.
void count_frame(std::int64_t texels_before, FrameWorkspace& work) {
    work.counts->stages.lit_texels = work.surfaces.built_texels() - texels_before;
}

}  // namespace

void draw_frame(const Scene& scene, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const Settings in_view = settings_in(view, settings);
    const FrameContext frame = begin_frame(scene, view, mode, in_view, work, out);
    const std::int64_t texels_before = work.surfaces.built_texels();
    if (frame.shared) frame.shared->begin(frame, work);
    work.plan = draw_view(frame, work);
    if (work.counts) count_frame(texels_before, work);
}

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    draw_frame(scene, first_person_view(camera, settings.accuracy.sine), mode, settings, work, out);
}

}  // namespace oblong
