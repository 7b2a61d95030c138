#include "engine/frame/frame.h"

#include <algorithm>

#include "engine/effects/sky.h"
#include "engine/frame/workspace.h"
#include "engine/frame/world_pass.h"
#include "engine/raster/fill.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

EffectSet effects_in_sight(const FrameWorkspace& work) {
    EffectSet effects;
    for (const LeafIndex leaf : work.visible.leaves()) {
        effects = effects | work.faces.leaf_effects[leaf];
        if (work.brush_models.has_any_in(leaf)) effects = effects.with(Effect::BrushModels);
    }
    return effects;
}

ViewContext make_view(const Camera& camera, const Vec3<World>& eye, const ScreenMode& mode, const Settings& settings) {
    ViewContext view;
    view.eye = eye;
    view.axes = view_basis(camera.yaw, camera.pitch, camera.roll);
    view.projection = make_projection(mode, camera.field_of_view, settings.correct_aspect);
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(settings.accuracy.subpixel_bits);
    return view;
}

const MipTexture* find_sky(const Level& level) {
    const auto found = std::find_if(level.textures.begin(), level.textures.end(),
                                    [](const MipTexture& texture) { return texture.name.starts_with("sky"); });
    return found == level.textures.end() ? nullptr : &*found;
}

void draw_sky_pass(const FrameContext& frame, const FrameWorkspace& work) {
    const MipTexture* texture = find_sky(frame.scene.level);
    const bool is_layered =
        texture && texture->width == 2 * texture->height && (texture->height & (texture->height - 1)) == 0;
    if (!is_layered) return fill_spans(work.sky_spans, texture ? texture->mips[0][0] : 0, frame.out);
    draw_sky(work.sky_spans, {texture->mips[0].data(), texture->height, texture->width}, frame.view.axes,
             frame.view.projection, frame.out);
}

}  // namespace

void draw_frame(const Scene& scene, const Camera& camera, const ScreenMode& mode, const Settings& settings,
                FrameWorkspace& work, Framebuffer out) {
    const PlacedEye eye = place_eye(scene.level, camera.eye);
    work.visible.see_from(scene.level, eye.leaf);
    work.brush_models.place(scene.level, scene.models, work.faces);
    work.plan = plan_frame(effects_in_sight(work), settings.allowed_effects);
    if (work.counts) *work.counts = make_frame_counts(out);

    const ViewContext view = make_view(camera, eye.position, mode, settings);
    const FrameContext frame{
        scene,     settings, view, make_inverse_projection(view.projection), make_block_rule(settings.accuracy),
        work.plan, out};
    draw_world(frame, work);
    if (work.plan.effects.has(Effect::Sky)) draw_sky_pass(frame, work);

    work.owned.clear();
    work.span_buffer.claim_rest(work.owned);
    fill_spans(work.owned, 0, out);
}

}  // namespace oblong
