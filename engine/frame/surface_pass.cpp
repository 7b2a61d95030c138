#include "engine/frame/surface_pass.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/texture_spans.h"
#include "engine/frame/workspace.h"
#include "engine/scene/face_surface.h"

namespace oblong {

namespace {

FaceSurface surface_of(FaceIndex face, int mip, const FrameContext& frame, FrameWorkspace& work) {
    const Stopwatch watch(work.times.get(), &FrameTimes::surfaces_ns);
    return work.surfaces.get(face, mip, frame.scene.light_styles);
}

/// Draws spans of a face with its texture of one mip level.
void draw_textured(const ClaimedFace& claimed, int mip, std::span<const Span> spans, const FrameContext& frame,
                   FrameWorkspace& work) {
    const FaceIndex index = claimed.visible.face;
    const FaceSurface surface = surface_of(index, mip, frame, work);
    const TextureGradients gradients = gradients_of(claimed.visible, surface, frame, work);
    if (work.counts) ++work.counts->stages.surfaces;
    const WidthAtOne width = frame.inverse_projection.least_pixel_width;
    const TexturedFace face{claimed, surface, gradients, work.faces.faces[index].least_density, width};
    draw_texture_spans(face, spans, frame.texturing, frame.out, work);
}

/// The mip level of a face for pixels no nearer than this.
int mip_level(FaceIndex face, View nearest_z, const FrameContext& frame, const FrameWorkspace& work) {
    return work.surfaces.mip_level(face, nearest_z, frame.view.projection.x, frame.accuracy().mip_bias);
}

/// Draws each span with the mip level of its nearest pixel.
void draw_by_span_mips(const ClaimedFace& claimed, const FrameContext& frame, FrameWorkspace& work) {
    const FaceSurface no_surface;  // 1/z does not depend on it
    const auto inverse_z = gradients_of(claimed.visible, no_surface, frame, work).inverse_z;
    for (std::vector<Span>& spans : work.of_mip) spans.clear();
    for (const Span& span : work.claims.spans_of(claimed)) {
        const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
        const auto nearest_z = reciprocal<View>(std::max({first, last, InverseZ::ulp()}));
        at(work.of_mip, mip_level(claimed.visible.face, nearest_z, frame, work)).push_back(span);
    }
    for (int mip = 0; mip < 4; ++mip)
        if (!at(work.of_mip, mip).empty()) draw_textured(claimed, mip, at(work.of_mip, mip), frame, work);
}

}  // namespace

TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Vec3<World> offset = visible.fragment ? work.brush_models.offset_of(*visible.fragment) : Vec3<World>{};
    const TextureGradients gradients =
        make_face_gradients(level, level.faces[visible.face], surface, offset, frame.view, frame.inverse_projection);
    const Accuracy& accuracy = frame.accuracy();
    if (accuracy.inverse_z_bits == InverseZ::kFractionBits && accuracy.over_z_bits == TexelOverZ::kFractionBits)
        return gradients;
    return rounded_to(gradients, accuracy.inverse_z_bits, accuracy.over_z_bits);
}

void draw_surfaces(FaceList list, const FrameContext& frame, FrameWorkspace& work) {
    const MipSelection selection = frame.accuracy().mip;
    for (const ClaimedFace& claimed : work.claims.list(list)) {
        const Stopwatch of_models(claimed.visible.fragment ? work.times.get() : nullptr, Effect::BrushModels);
        if (selection == MipSelection::Span) {
            draw_by_span_mips(claimed, frame, work);
            continue;
        }
        const bool is_chosen = selection == MipSelection::Face;
        const int mip = is_chosen ? mip_level(claimed.visible.face, claimed.nearest_z, frame, work) : 0;
        draw_textured(claimed, mip, work.claims.spans_of(claimed), frame, work);
    }
}

}  // namespace oblong
