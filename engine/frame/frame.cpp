#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/effects/sky.h"
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
    BlockRule block_rule;
    Framebuffer out;
};

ViewContext make_view(const Camera& camera, const Vec3<World>& eye, const ScreenMode& mode, const Settings& settings) {
    ViewContext view;
    view.eye = eye;
    view.axes = view_basis(camera.yaw, camera.pitch, camera.roll);
    view.projection = make_projection(mode, camera.field_of_view, settings.correct_aspect);
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(settings.accuracy.subpixel_bits);
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
    work.span_buffer.reset();
    work.sky_spans.clear();
    work.plan = plan_frame(effects_in_sight(work), settings.allowed_effects);
    if (work.counts) *work.counts = make_frame_counts(out);

    const ViewContext view = make_view(camera, eye.position, mode, settings);
    return {scene, view, make_inverse_projection(view.projection), make_block_rule(settings.accuracy), out};
}

/// Transforms, clips and projects the corners into work.polygon. False if nothing of the face is in view.
bool project(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    if (work.counts) ++work.counts->faces_visited;
    if (visible.fragment)
        return project_polygon(work.brush_models.corners_of(*visible.fragment), frame.view, work.polygon);
    return project_face(work.faces.corners_of(visible.face), frame.view, work.vertices, work.polygon);
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
    if (is_on_plan) {
        work.sky_spans.insert(work.sky_spans.end(), work.owned.begin(), work.owned.end());
        return true;
    }
    fill_spans(work.owned, level.texture_of(level.faces[visible.face]).mips[3][0], frame.out);
    return true;
}

void draw_waiting_blocks(const FaceSurface& surface, Framebuffer out, FrameWorkspace& work) {
    surface.kernel(work.blocks.waiting(), surface.view, out.pixels);
    if (work.counts) count_writes(work.blocks.waiting(), *work.counts);
    work.blocks.clear();
}

/// Cuts the owned spans into blocks, then draws them.
void draw_textured(const FaceSurface& surface, const TextureGradients& gradients, const FrameContext& frame,
                   FrameWorkspace& work) {
    const BlockThresholds thresholds = make_block_thresholds(frame.block_rule, gradients.inverse_z.per_column);
    for (const Span& span : work.owned) {
        if (!work.blocks.has_room_for(span.end - span.first)) draw_waiting_blocks(surface, frame.out, work);
        const std::int32_t divisions =
            append_blocks(span, frame.out.pitch, gradients, frame.block_rule, thresholds, surface.limits, work.blocks);
        if (work.counts) work.counts->divisions += divisions;
    }
    draw_waiting_blocks(surface, frame.out, work);
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

}  // namespace

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const FrameContext frame = begin_frame(scene, camera, mode, settings, work, out);
    const Level& level = scene.level;
    BrushModels* const models = work.plan.effects.has(Effect::BrushModels) ? &work.brush_models : nullptr;

    FrontToBackWalk walk(level, frame.view, work.visible, models, work.span_buffer, work.walk);
    while (const std::optional<VisibleFace> visible = walk.next()) {
        if (!project(*visible, frame, work)) continue;
        scan_convex(work.polygon.screen, work.rows);
        work.owned.clear();
        work.span_buffer.claim(work.rows, work.owned);
        if (work.owned.empty() || draw_without_surface(*visible, frame, work)) continue;

        const Vec3<World> offset = visible->fragment ? work.brush_models.offset_of(*visible->fragment) : Vec3<World>{};
        const Face& face = level.faces[visible->face];
        const FaceSurface surface = work.surfaces.get(visible->face, work.polygon.nearest_z, frame.view.projection.x,
                                                      scene.colormap, scene.light_styles);
        const TextureGradients gradients =
            make_face_gradients(level, face, surface, offset, frame.view, frame.inverse_projection);
        draw_textured(surface, gradients, frame, work);
    }
    if (work.plan.effects.has(Effect::Sky)) draw_sky_pass(frame, work);
    fill_free_pixels(work, out);
}

}  // namespace oblong
