#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/passes.h"
#include "engine/frame/workspace.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

ViewContext make_view(const Camera& camera, const Vec3<World>& eye, const ScreenMode& mode, const Settings& settings) {
    ViewContext view;
    view.eye = eye;
    const Accuracy& accuracy = settings.accuracy;
    view.axes = rounded_to(view_basis(camera.yaw, camera.pitch, camera.roll, accuracy.sine), accuracy.matrix_bits);
    view.projection = make_projection(mode, camera.field_of_view, settings.correct_aspect);
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(accuracy.subpixel_bits);
    view.view_bits = accuracy.view_bits;
    return view;
}

/// Moves the eye clear of planes, and finds what may be seen from there.
FrameContext begin_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                         FrameWorkspace& work, Framebuffer out) {
    if (work.times) *work.times = {work.times->clock};
    const PlacedEye eye = place_eye(scene.level, camera.eye);
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

    const ViewContext view = make_view(camera, eye.position, mode, settings);
    return {scene,
            settings,
            view,
            make_inverse_projection(view.projection),
            make_span_texturing(settings.accuracy),
            out,
            scene.level.leaves[eye.leaf].contents};
}

/// Adds what is known at the end of a frame only.
void count_frame(std::int64_t texels_before, FrameWorkspace& work) {
    work.counts->stages.lit_texels = work.surfaces.built_texels() - texels_before;
}

}  // namespace

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const FrameContext frame = begin_frame(scene, camera, mode, settings, work, out);
    const std::int64_t texels_before = work.surfaces.built_texels();
    work.plan = draw_view(frame, work);
    if (work.counts) count_frame(texels_before, work);
}

}  // namespace oblong
