#include "engine/frame/passes.h"

#include <algorithm>

#include "engine/effects/sky.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

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
        case Pass::Mirror:
            return draw_mirrors(frame, work);
    }
}

/// Fills pixels that no face covers. From inside a wall they show the void: colour 0. From the open they are gaps
/// between faces that do not meet: the colour of the nearest covered pixel on the row.
void fill_free_pixels(const FrameWorkspace& work, Framebuffer out) {
    for (const Span& span : work.claims.left_free) {
        std::uint8_t* const row = out.row(span.y);
        const bool has_left = work.visible.is_from_open() && span.first > 0;
        const bool has_right = work.visible.is_from_open() && span.end < out.width_px;
        const std::int32_t middle = !has_left ? span.first : !has_right ? span.end : (span.first + span.end + 1) / 2;
        std::fill(row + span.first, row + middle, has_left ? row[span.first - 1] : std::uint8_t{0});
        std::fill(row + middle, row + span.end, has_right ? row[span.end] : std::uint8_t{0});
    }
}

}  // namespace

FramePlan draw_view(const FrameContext& frame, FrameWorkspace& work) {
    claim_faces(frame, work);
    FramePlan plan = plan_frame(work.claims);
    for (const Pass pass : plan.passes) run(pass, frame, work);
    fill_free_pixels(work, frame.out);
    return plan;
}

}  // namespace oblong
