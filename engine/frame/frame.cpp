#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/effects/sky.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/texture_spans.h"
#include "engine/frame/workspace.h"
#include "engine/scene/face_surface.h"
#include "engine/screen/screen.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// Everything that is constant while the faces of a frame are drawn.
struct FrameContext {
    const Scene& scene;
    ViewContext view;
    InverseProjection inverse_projection;
    const Accuracy& accuracy;
    SpanTexturing texturing;
    Framebuffer out;
};

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

EffectSet effects_in_sight(const FrameWorkspace& work) {
    EffectSet effects;
    for (const LeafIndex leaf : work.visible.leaves())
        effects = effects | work.faces.leaf_effects[leaf] | work.brush_models.effects_in(leaf);
    return effects;
}

/// Moves the eye clear of planes, finds what may be seen from there, and plans the frame.
FrameContext begin_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                         FrameWorkspace& work, Framebuffer out) {
    const PlacedEye eye = place_eye(scene.level, camera.eye);
    work.visible.see_from(scene.level, eye.leaf);
    work.brush_models.start_frame(scene.level, scene.models, work.faces);
    work.vertices.start_frame();
    work.surfaces.start_frame(settings.accuracy, settings.brightness_100, scene.colormap);
    work.span_buffer.reset();
    work.sky_spans.clear();
    work.plan = plan_frame(effects_in_sight(work), settings.allowed_effects);
    if (work.counts) *work.counts = make_frame_counts(out);
    if (work.record) work.record->pixels.assign(pixel_count(out.pitch, out.height_px), {});

    const ViewContext view = make_view(camera, eye.position, mode, settings);
    const Accuracy& accuracy = settings.accuracy;
    return {scene, view, make_inverse_projection(view.projection), accuracy, make_span_texturing(accuracy), out};
}

/// The corners of a face, those at T-junctions only if the settings mend them.
std::span<const VertexIndex> corners_of(FaceIndex index, const FrameContext& frame, FrameWorkspace& work) {
    if (frame.accuracy.mends_t_junctions) return work.faces.corners_of(index);
    const Level& level = frame.scene.level;
    work.own_corners.clear();
    for (const SurfEdge step : level.edges_of(level.faces[index])) work.own_corners.push_back(level.start_of(step));
    return work.own_corners;
}

/// Transforms, clips and projects the corners into work.polygon. False if nothing of the face is in view.
bool project(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    if (work.counts) ++work.counts->faces_visited;
    if (visible.fragment)
        return project_polygon(work.brush_models.corners_of(*visible.fragment), frame.view, work.polygon);
    return project_face(corners_of(visible.face, frame, work), frame.view, work.vertices, work.polygon);
}

/// Collects sky spans for the sky pass, and fills faces whose effect is not on the plan with one colour of their
/// texture. False for all other faces.
bool draw_without_surface(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Material material = work.faces.faces[visible.face].material;
    const EffectSet effects = effects_of(material);
    if (work.counts)
        count_face(visible.fragment ? effects.with(Effect::BrushModels) : effects, work.owned, *work.counts);
    const bool is_on_plan = (effects & work.plan.effects) == effects;
    if (is_on_plan && material != Material::Sky) return false;
    if (work.counts) count_writes(work.owned, frame.out.pitch, *work.counts);
    if (work.record) record_spans(record_of(visible), work.owned, frame.out, *work.record);
    if (is_on_plan) {
        work.sky_spans.insert(work.sky_spans.end(), work.owned.begin(), work.owned.end());
        return true;
    }
    fill_spans(work.owned, level.texture_of(level.faces[visible.face]).mips[3][0], frame.out);
    return true;
}

TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Vec3<World> offset = visible.fragment ? work.brush_models.offset_of(*visible.fragment) : Vec3<World>{};
    const TextureGradients gradients =
        make_face_gradients(level, level.faces[visible.face], surface, offset, frame.view, frame.inverse_projection);
    const Accuracy& accuracy = frame.accuracy;
    if (accuracy.inverse_z_bits == InverseZ::kFractionBits && accuracy.over_z_bits == TexelOverZ::kFractionBits)
        return gradients;
    return rounded_to(gradients, accuracy.inverse_z_bits, accuracy.over_z_bits);
}

/// Draws spans of a face with its texture of one mip level.
void draw_textured(const VisibleFace& visible, int mip, std::span<const Span> spans, const FrameContext& frame,
                   FrameWorkspace& work) {
    const FaceSurface surface = work.surfaces.get(visible.face, mip, frame.scene.light_styles);
    const TextureGradients gradients = gradients_of(visible, surface, frame, work);
    if (work.counts) ++work.counts->stages.surfaces;
    const WidthAtOne width = frame.inverse_projection.least_pixel_width;
    const TexturedFace face{visible, surface, gradients, work.faces.faces[visible.face].least_density, width};
    draw_texture_spans(face, spans, frame.texturing, frame.out, work);
}

/// The mip level of a face for pixels no nearer than this.
int mip_level(FaceIndex face, View nearest_z, const FrameContext& frame, const FrameWorkspace& work) {
    return work.surfaces.mip_level(face, nearest_z, frame.view.projection.x, frame.accuracy.mip_bias);
}

/// Draws each owned span with the mip level of its nearest pixel.
void draw_by_span_mips(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    const FaceSurface no_surface;  // 1/z does not depend on it
    const auto inverse_z = gradients_of(visible, no_surface, frame, work).inverse_z;
    for (std::vector<Span>& spans : work.of_mip) spans.clear();
    for (const Span& span : work.owned) {
        const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
        const auto nearest_z = reciprocal<View>(std::max({first, last, InverseZ::ulp()}));
        at(work.of_mip, mip_level(visible.face, nearest_z, frame, work)).push_back(span);
    }
    for (int mip = 0; mip < 4; ++mip)
        if (!at(work.of_mip, mip).empty()) draw_textured(visible, mip, at(work.of_mip, mip), frame, work);
}

void draw_with_mips(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    const MipSelection selection = frame.accuracy.mip;
    if (selection == MipSelection::Span) return draw_by_span_mips(visible, frame, work);
    const bool is_chosen = selection == MipSelection::Face;
    draw_textured(visible, is_chosen ? mip_level(visible.face, work.polygon.nearest_z, frame, work) : 0, work.owned,
                  frame, work);
}

void draw_sky_pass(const FrameContext& frame, const FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const MipTexture& texture = level.textures[level.sky];
    const bool is_layered = texture.width == 2 * texture.height && (texture.height & (texture.height - 1)) == 0;
    if (!is_layered) return fill_spans(work.sky_spans, texture.mips[0][0], frame.out);
    draw_sky(work.sky_spans, {texture.mips[0].data(), texture.height, texture.width}, frame.view.axes,
             frame.view.projection, frame.out);
}

/// Fills pixels that no face covers. From inside a wall they show the void: colour 0. From the open they are gaps
/// between faces that do not meet: the colour of the nearest covered pixel on the row.
void fill_free_pixels(FrameWorkspace& work, Framebuffer out) {
    work.owned.clear();
    work.span_buffer.claim_rest(work.owned);
    for (const Span& span : work.owned) {
        std::uint8_t* const row = out.row(span.y);
        const bool has_left = work.visible.is_from_open() && span.first > 0;
        const bool has_right = work.visible.is_from_open() && span.end < out.width_px;
        const std::int32_t middle = !has_left ? span.first : !has_right ? span.end : (span.first + span.end + 1) / 2;
        std::fill(row + span.first, row + middle, has_left ? row[span.first - 1] : std::uint8_t{0});
        std::fill(row + middle, row + span.end, has_right ? row[span.end] : std::uint8_t{0});
    }
}

/// Adds what is known at the end of a frame only.
void count_frame(std::int64_t nodes, std::int64_t texels_before, FrameWorkspace& work) {
    StageCounts& stages = work.counts->stages;
    const VertexCache::Counts vertices = work.vertices.count();
    stages.nodes = nodes;
    stages.vertices = vertices.transformed;
    stages.projected = vertices.projected;
    stages.lit_texels = work.surfaces.built_texels() - texels_before;
    stages.sky_pixels = pixels_of(work.sky_spans);
    stages.flat_pixels -= stages.sky_pixels;
}

}  // namespace

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const FrameContext frame = begin_frame(scene, camera, mode, settings, work, out);
    const Level& level = scene.level;
    const std::int64_t texels_before = work.surfaces.built_texels();
    BrushModels* const models = work.plan.effects.has(Effect::BrushModels) ? &work.brush_models : nullptr;

    FrontToBackWalk walk(level, frame.view, work.visible, models, work.span_buffer, work.walk);
    while (const std::optional<VisibleFace> visible = walk.next()) {
        if (!project(*visible, frame, work)) continue;
        scan_convex(work.polygon.screen, work.rows, frame.accuracy.edges);
        if (work.counts) count_polygon(work.polygon, work.rows, work.counts->stages);
        work.owned.clear();
        work.span_buffer.claim(work.rows, work.owned);
        if (work.owned.empty() || draw_without_surface(*visible, frame, work)) continue;
        draw_with_mips(*visible, frame, work);
    }
    if (work.counts) count_frame(walk.nodes_entered(), texels_before, work);
    if (work.plan.effects.has(Effect::Sky)) draw_sky_pass(frame, work);
    fill_free_pixels(work, out);
}

}  // namespace oblong
