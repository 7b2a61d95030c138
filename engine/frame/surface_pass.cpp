#include "engine/frame/surface_pass.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/texture_spans.h"
#include "engine/frame/workspace.h"
#include "engine/scene/face_surface.h"

namespace oblong {

namespace {

/// The texture that a face shows now; none: its own.
TextureIndex texture_now(const VisibleFace& visible, const FrameContext& frame, const FrameWorkspace& work) {
    if (!work.faces.faces[visible.face].effects.has(Effect::AnimatedTextures)) return TextureIndex::none();
    if (!frame.allows(Effect::AnimatedTextures)) return TextureIndex::none();
    const Level& level = frame.scene.level;
    const bool is_switched = visible.fragment && work.brush_models.is_switched(*visible.fragment);
    return work.effects.animations.shown(level.texinfos[level.faces[visible.face].texinfo].texture, is_switched,
                                         frame.scene.time_ms);
}

/// The effect that building a face's surface is for; none for faces whose surface stays.
std::optional<Effect> reason_to_build(const VisibleFace& visible, FrameWorkspace& work) {
    const EffectSet effects = work.faces.faces[visible.face].effects & work.claims.effects;
    const Vec3<World> offset = work.brush_models.offset_of(visible.fragment);
    if (work.claims.effects.has(Effect::Lights) && work.surfaces.is_touched(visible.face, offset))
        return Effect::Lights;
    if (effects.has(Effect::Styles)) return Effect::Styles;
    if (effects.has(Effect::AnimatedTextures)) return Effect::AnimatedTextures;
    return std::nullopt;
}

FaceSurface surface_of(const VisibleFace& visible, int mip, const FrameContext& frame, FrameWorkspace& work) {
    const std::optional<Effect> reason = work.times ? reason_to_build(visible, work) : std::nullopt;
    const Stopwatch of_effect(reason ? work.times.get() : nullptr, reason.value_or(Effect::Styles));
    const Vec3<World> offset = work.brush_models.offset_of(visible.fragment);
    return work.surfaces.get(visible.face, mip, {work.light_styles, texture_now(visible, frame, work), offset});
}

/// The kernel of a drawing that is not plain, and what it needs.
SurfaceEffect effect_of(const SurfaceDrawing& drawing, const FaceSurface& surface, const FrameContext& frame,
                        FrameWorkspace& work) {
    TexelTraits traits = drawing.traits;
    traits.is_wrapped_by_masks = surface.is_wrapped_by_masks;
    if (traits.warps && work.warp_time_ms != frame.scene.time_ms) {
        work.warp = make_warp_tables(frame.scene.time_ms);
        work.warp_time_ms = frame.scene.time_ms;
    }
    return {effect_kernel(traits),
            {surface.view, &at(work.warp, surface.mip), drawing.colours, drawing.blend},
            traits.warps && !traits.has_holes && !traits.blends};
}

/// Draws spans of a face with its texture of one mip level.
void draw_textured(const ClaimedFace& claimed, int mip, std::span<const Span> spans, const SurfaceDrawing& drawing,
                   const FrameContext& frame, FrameWorkspace& work) {
    const FaceSurface surface = surface_of(claimed.visible, mip, frame, work);
    const SurfaceEffect effect = drawing.is_plain ? SurfaceEffect{} : effect_of(drawing, surface, frame, work);
    if (is_shared(frame)) return frame.shared->add(claimed, surface, effect, spans);
    if (work.counts) ++work.counts->stages.surfaces;
    draw_with_surface(claimed, surface, effect, spans, frame, work,
                      {frame.texturing, frame.out, work.span_scratch, work.counts.get(), work.record.get()});
}

/// The mip level of a face for pixels no nearer than this.
int mip_level(FaceIndex face, View nearest_z, const FrameContext& frame, const FrameWorkspace& work) {
    return work.surfaces.mip_level(face, nearest_z, frame.view.projection.x, frame.accuracy().mip_bias);
}

/// Draws each span with the mip level of its nearest pixel.
void draw_by_span_mips(const ClaimedFace& claimed, std::span<const Span> whole, const SurfaceDrawing& drawing,
                       const FrameContext& frame, FrameWorkspace& work) {
    const FaceSurface no_surface;  // 1/z does not depend on it
    const auto inverse_z = gradients_of(claimed.visible, no_surface, frame, work).inverse_z;
    for (std::vector<Span>& spans : work.of_mip) spans.clear();
    for (const Span& span : whole) {
        const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
        const auto nearest_z = reciprocal<View>(std::max({first, last, InverseZ::ulp()}));
        at(work.of_mip, mip_level(claimed.visible.face, nearest_z, frame, work)).push_back(span);
    }
    for (int mip = 0; mip < 4; ++mip)
        if (!at(work.of_mip, mip).empty()) draw_textured(claimed, mip, at(work.of_mip, mip), drawing, frame, work);
}

}  // namespace

TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Vec3<World> offset = work.brush_models.offset_of(visible.fragment);
    const TextureGradients gradients =
        make_face_gradients(level, level.faces[visible.face], surface, offset, frame.view, frame.inverse_projection);
    const Accuracy& accuracy = frame.accuracy();
    if (accuracy.inverse_z_bits == InverseZ::kFractionBits && accuracy.over_z_bits == TexelOverZ::kFractionBits)
        return gradients;
    return rounded_to(gradients, accuracy.inverse_z_bits, accuracy.over_z_bits);
}

void draw_with_surface(const ClaimedFace& claimed, const FaceSurface& surface, const SurfaceEffect& effect,
                       std::span<const Span> spans, const FrameContext& frame, const FrameWorkspace& work,
                       const SpanDrawing& drawing) {
    const TextureGradients gradients = gradients_of(claimed.visible, surface, frame, work);
    draw_texture_spans({claimed, surface, effect, gradients, work.faces.faces[claimed.visible.face].least_density,
                        frame.inverse_projection.least_pixel_width},
                       spans, drawing);
}

void draw_surface(const ClaimedFace& claimed, std::span<const Span> spans, const SurfaceDrawing& drawing,
                  const FrameContext& frame, FrameWorkspace& work) {
    const MipSelection selection = frame.accuracy().mip;
    if (selection == MipSelection::Span) return draw_by_span_mips(claimed, spans, drawing, frame, work);
    const bool is_chosen = selection == MipSelection::Face;
    const int mip = is_chosen ? mip_level(claimed.visible.face, claimed.nearest_z, frame, work) : 0;
    draw_textured(claimed, mip, spans, drawing, frame, work);
}

void draw_surfaces(FaceList list, const SurfaceDrawing& drawing, const FrameContext& frame, FrameWorkspace& work) {
    if (is_shared(frame)) return share_surfaces(list, drawing, frame, work);
    for (const ClaimedFace& claimed : work.claims.list(list)) {
        const Stopwatch of_models(claimed.visible.fragment ? work.times.get() : nullptr, Effect::BrushModels);
        draw_surface(claimed, work.claims.spans_of(claimed), drawing, frame, work);
    }
}

void share_surfaces(FaceList list, const SurfaceDrawing& drawing, const FrameContext& frame, FrameWorkspace& work) {
    const std::vector<ClaimedFace>& faces = work.claims.list(list);
    for (std::size_t& shared = frame.shared->face_count(list); shared < faces.size(); ++shared)
        draw_surface(faces[shared], work.claims.spans_of(faces[shared]), drawing, frame, work);
}

}  // namespace oblong
