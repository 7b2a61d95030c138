#include "engine/frame/draw_face.h"

#include "engine/frame/face_gradients.h"
#include "engine/frame/face_surface.h"
#include "engine/raster/fill.h"

namespace oblong {

namespace {

void draw_waiting_blocks(const FaceSurface& surface, const FrameContext& frame, FrameWorkspace& work) {
    surface.kernel(work.blocks.waiting(), surface.view, frame.out.pixels);
    if (work.counts) count_writes(work.blocks.waiting(), *work.counts);
    work.blocks.clear();
}

void draw_textured(FaceIndex face_index, const Vec3<World>& offset, const FrameContext& frame, FrameWorkspace& work) {
    const Face& face = frame.scene.level.faces[face_index];
    const FaceSurface surface = choose_face_surface(face_index, work.polygon.nearest_z_16, frame, work);
    const TextureGradients gradients = make_face_gradients(face, surface, offset, frame);
    const BlockThresholds thresholds =
        make_block_thresholds(frame.block_rule, static_cast<std::int64_t>(gradients.inverse_z_44.per_column));
    for (const Span& span : work.owned) {
        if (!work.blocks.has_room_for(span.end - span.first)) draw_waiting_blocks(surface, frame, work);
        const std::int32_t divisions =
            append_blocks(span, frame.out.pitch, gradients, frame.block_rule, thresholds, surface.limits, work.blocks);
        if (work.counts) work.counts->divisions += divisions;
    }
    draw_waiting_blocks(surface, frame, work);
}

/// In place of an effect that is not on the plan: one colour of its texture.
void draw_flat(FaceIndex face_index, const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Face& face = level.faces[face_index];
    fill_spans(work.owned, level.texture_of(face).mips[3][0], frame.out);
    if (work.counts) count_writes(work.owned, frame.out.pitch, *work.counts);
}

void leave_to_sky(const FrameContext& frame, FrameWorkspace& work) {
    work.sky_spans.insert(work.sky_spans.end(), work.owned.begin(), work.owned.end());
    if (work.counts) count_writes(work.owned, frame.out.pitch, *work.counts);
}

/// Draws the face whose polygon is in work.polygon.
void draw_outline(FaceIndex face_index, const Vec3<World>& offset, const FrameContext& frame, FrameWorkspace& work) {
    work.owned.clear();
    claim_polygon(work.polygon.screen, work.rows, work.span_buffer, work.owned);
    if (work.owned.empty()) return;
    const FaceKind kind = work.faces.faces[face_index].kind;
    const EffectSet effects = effects_of(kind);
    if (work.counts) count_face(effects, work.owned, *work.counts);
    if ((effects & frame.plan.effects) != effects) return draw_flat(face_index, frame, work);
    if (kind == FaceKind::Sky) return leave_to_sky(frame, work);
    draw_textured(face_index, offset, frame, work);
}

}  // namespace

void draw_world_face(FaceIndex face_index, const FrameContext& frame, FrameWorkspace& work) {
    if (work.counts) ++work.counts->faces_visited;
    if (project_face(work.faces.corners_of(face_index), frame.view, work.vertices, work.polygon))
        draw_outline(face_index, {}, frame, work);
}

void draw_fragments_in(LeafIndex leaf, const FrameContext& frame, FrameWorkspace& work) {
    if (!work.brush_models.has_any_in(leaf)) return;
    for (const Fragment* fragment : work.brush_models.front_to_back_in(leaf, frame.scene.level, frame.view.eye)) {
        if (work.counts) ++work.counts->faces_visited;
        if (project_polygon(work.brush_models.corners_of(*fragment), frame.view, work.polygon))
            draw_outline(fragment->face, work.brush_models.offset_of(*fragment), frame, work);
    }
}

}  // namespace oblong
