#include "engine/frame/frame_light.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

void find_styles(bool are_wanted, const FrameContext& frame, ViewScratch& scratch) {
    scratch.light.styles = frame.scene.light_styles;
    if (!are_wanted) return;
    const LightStyles patterns =
        light_styles_at(frame.cache.effects.light_patterns, frame.scene.time_ms, frame.settings.flashes);
    for (std::size_t style = 0; style < patterns.size(); ++style) {
        const std::uint32_t brightness =
            std::uint32_t{scratch.light.styles[style]} * patterns[style] / kStoredBrightness;
        scratch.light.styles[style] = static_cast<std::uint16_t>(std::min<std::uint32_t>(brightness, 0xffff));
    }
}

/// The lights that may touch something in view. With mirrors it takes all lights: if their sets differed, a face shown
/// in both pictures would be built twice.
void gather_lights(const FrameContext& frame, ViewScratch& scratch) {
    const bool has_mirrors = frame.mirror || !scratch.claims.list(FaceList::Mirror).empty();
    scratch.light.moving.assign(frame.scene.moving_lights.begin(), frame.scene.moving_lights.end());
    if (frame.cache.things.lanterns.empty()) return;
    const BoxCuller culler(frame.view.frustum, frame.view.eye);
    const bool lights_faces_alone = scratch.claims.things.meshes.empty() && frame.limits.empty();
    const LeafSet& leaves = lights_faces_alone ? scratch.claiming->walk.entered : scratch.visible.leaf_set();
    for (const PlacedLantern& placed : frame.cache.things.lanterns) {
        if (!has_mirrors && !may_be_seen(placed.lit, leaves, culler)) continue;
        const Sprite lantern = lantern_at(placed.lantern, frame.scene.time_ms);
        scratch.light.moving.push_back({lantern.position, placed.lantern.light_radius});
    }
}

/// Whether a light touches a face that owns pixels.
bool find_touched(const FrameContext& frame, const ViewScratch& scratch) {
    bool is_any = false;
    const bool are_lanterns = frame.scene.moving_lights.empty();
    for (const FaceList list : {FaceList::Walls, FaceList::SeeThrough})
        for (const VisibleFace& claimed : scratch.claims.list(list)) {
            if (are_lanterns && !claimed.fragment && !frame.cache.faces[claimed.face].is_near_lantern) continue;
            if (!frame.cache.surfaces.is_touched(claimed.face, frame.offset_of(claimed))) continue;
            if (!frame.observers.counts) return true;
            is_any = true;
            frame.observers.counts->of(Effect::Lights) += pixels_of(scratch.claims.spans_of(claimed));
        }
    return is_any;
}

}  // namespace

bool find_light_beforehand(const FrameContext& frame, ViewScratch& scratch) {
    const bool may_have_lights = !frame.scene.moving_lights.empty() || !frame.cache.things.lanterns.empty();
    if (may_have_lights && frame.allows(Effect::Lights)) return false;
    find_styles(frame.allows(Effect::Styles), frame, scratch);
    frame.cache.surfaces.set_moving_lights({}, frame.view.eye);
    return true;
}

void find_light(const FrameContext& frame, ViewScratch& scratch) {
    const Claims& claims = scratch.claims;
    find_styles(claims.effects.has(Effect::Styles) || (!claims.things.meshes.empty() && frame.allows(Effect::Styles)),
                frame, scratch);
    if (!frame.allows(Effect::Lights))
        scratch.light.moving.clear();
    else
        gather_lights(frame, scratch);
    if (scratch.light.moving.empty() && !frame.cache.surfaces.has_moving_lights()) return;
    frame.cache.surfaces.set_moving_lights(scratch.light.moving, frame.view.eye);
    if (frame.cache.surfaces.has_moving_lights() && find_touched(frame, scratch))
        scratch.claims.effects = scratch.claims.effects.with(Effect::Lights);
    restore_light(frame, scratch);
}

void restore_light(const FrameContext& frame, const ViewScratch& scratch) {
    const bool are_seen = scratch.claims.effects.has(Effect::Lights);
    frame.cache.surfaces.set_moving_lights(
        are_seen ? std::span<const MovingLight>(scratch.light.moving) : std::span<const MovingLight>(), frame.view.eye);
}

}  // namespace oblong
