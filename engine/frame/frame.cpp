#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/effects/sky.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
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
    work.surfaces.start_frame(settings.accuracy, scene.colormap);
    work.span_buffer.reset();
    work.claims.clear();
    if (work.counts) *work.counts = make_frame_counts(out);
    if (work.record) work.record->pixels.assign(pixel_count(out.pitch, out.height_px), {});

    const ViewContext view = make_view(camera, eye.position, mode, settings);
    return {scene, settings, view, make_inverse_projection(view.projection), make_span_texturing(settings.accuracy),
            out};
}

/// Counts and records spans that are drawn without a surface.
void note_flat(const ClaimedFace& claimed, std::span<const Span> spans, Framebuffer out, FrameWorkspace& work) {
    if (work.counts) count_writes(spans, out.pitch, *work.counts);
    if (work.record) record_spans(record_of(claimed.visible), spans, out, *work.record);
}

/// Fills faces whose effect is not allowed with one colour of their texture.
void draw_flat(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    for (const ClaimedFace& claimed : work.claims.list(FaceList::Flat)) {
        const std::span<const Span> spans = work.claims.spans_of(claimed);
        note_flat(claimed, spans, frame.out, work);
        fill_spans(spans, level.texture_of(level.faces[claimed.visible.face]).mips[3][0], frame.out);
    }
}

void draw_sky_faces(const FrameContext& frame, FrameWorkspace& work) {
    work.pass_spans.clear();
    for (const ClaimedFace& claimed : work.claims.list(FaceList::Sky)) {
        const std::span<const Span> spans = work.claims.spans_of(claimed);
        note_flat(claimed, spans, frame.out, work);
        work.pass_spans.insert(work.pass_spans.end(), spans.begin(), spans.end());
    }
    if (work.counts) count_sky(work.pass_spans, *work.counts);
    const Level& level = frame.scene.level;
    const MipTexture& texture = level.textures[level.sky];
    const bool is_layered = texture.width == 2 * texture.height && (texture.height & (texture.height - 1)) == 0;
    if (!is_layered) return fill_spans(work.pass_spans, texture.mips[0][0], frame.out);
    draw_sky(work.pass_spans, {texture.mips[0].data(), texture.height, texture.width}, frame.view.axes,
             frame.view.projection, frame.out);
}

void run(Pass pass, const FrameContext& frame, FrameWorkspace& work) {
    const Stopwatch watch(work.times.get(), pass);
    switch (pass) {
        case Pass::Walls:
            return draw_surfaces(FaceList::Walls, frame, work);
        case Pass::Flat:
            return draw_flat(frame, work);
        case Pass::Liquid:
            return draw_surfaces(FaceList::Liquid, frame, work);
        case Pass::Sky:
            return draw_sky_faces(frame, work);
    }
}

/// Fills pixels that no face covers. From inside a wall they show the void: colour 0. From the open they are gaps
/// between faces that do not meet: the colour of the nearest covered pixel on the row.
void fill_free_pixels(FrameWorkspace& work, Framebuffer out) {
    work.pass_spans.clear();
    work.span_buffer.claim_rest(work.pass_spans);
    for (const Span& span : work.pass_spans) {
        std::uint8_t* const row = out.row(span.y);
        const bool has_left = work.visible.is_from_open() && span.first > 0;
        const bool has_right = work.visible.is_from_open() && span.end < out.width_px;
        const std::int32_t middle = !has_left ? span.first : !has_right ? span.end : (span.first + span.end + 1) / 2;
        std::fill(row + span.first, row + middle, has_left ? row[span.first - 1] : std::uint8_t{0});
        std::fill(row + middle, row + span.end, has_right ? row[span.end] : std::uint8_t{0});
    }
}

/// Adds what is known at the end of a frame only.
void count_frame(std::int64_t texels_before, FrameWorkspace& work) {
    StageCounts& stages = work.counts->stages;
    const VertexCache::Counts vertices = work.vertices.count();
    stages.vertices = vertices.transformed;
    stages.projected = vertices.projected;
    stages.lit_texels = work.surfaces.built_texels() - texels_before;
    work.counts->pass_pixels = {pixels_of(work.claims, FaceList::Walls), pixels_of(work.claims, FaceList::Flat),
                                pixels_of(work.claims, FaceList::Liquid), pixels_of(work.claims, FaceList::Sky)};
}

}  // namespace

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const FrameContext frame = begin_frame(scene, camera, mode, settings, work, out);
    const std::int64_t texels_before = work.surfaces.built_texels();
    claim_faces(frame, work);
    work.plan = plan_frame(work.claims);
    for (const Pass pass : work.plan.passes) run(pass, frame, work);
    fill_free_pixels(work, out);
    if (work.counts) count_frame(texels_before, work);
}

}  // namespace oblong
