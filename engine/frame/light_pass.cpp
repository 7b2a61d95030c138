#include "engine/frame/light_pass.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

void find_styles(bool are_wanted, const FrameContext& frame, FrameWorkspace& work) {
    work.light_styles = frame.scene.light_styles;
    if (!are_wanted) return;
    const LightStyles patterns =
        light_styles_at(work.effects.light_patterns, frame.scene.time_ms, frame.settings.flashes);
    for (std::size_t style = 0; style < patterns.size(); ++style) {
        const std::uint32_t brightness = std::uint32_t{work.light_styles[style]} * patterns[style] / kStoredBrightness;
        work.light_styles[style] = static_cast<std::uint16_t>(std::min<std::uint32_t>(brightness, 0xffff));
    }
}

/// The lights that may touch something in view. With mirrors all of them: a face that both pictures show would be lit
/// again for each if their lights were not the same.
void gather_lights(const FrameContext& frame, FrameWorkspace& work) {
    const bool has_mirrors = frame.mirror || !work.claims.list(FaceList::Mirror).empty();
    work.lights.assign(frame.scene.moving_lights.begin(), frame.scene.moving_lights.end());
    for (const PlacedLantern& placed : work.things.lanterns) {
        if (!has_mirrors && !may_be_seen(placed.lit, work.visible, frame.view)) continue;
        const Sprite lantern = lantern_at(placed.lantern, frame.scene.time_ms);
        work.lights.push_back({lantern.position, placed.lantern.light_radius});
    }
}

/// Whether a light touches a face that owns pixels.
bool find_touched(FrameWorkspace& work) {
    bool is_any = false;
    for (const FaceList list : {FaceList::Walls, FaceList::SeeThrough})
        for (const ClaimedFace& claimed : work.claims.list(list)) {
            const Vec3<World> offset = work.brush_models.offset_of(claimed.visible.fragment);
            if (!work.surfaces.is_touched(claimed.visible.face, offset)) continue;
            is_any = true;
            if (work.counts) work.counts->of(Effect::Lights) += pixels_of(work.claims.spans_of(claimed));
        }
    return is_any;
}

}  // namespace

bool find_light_beforehand(const FrameContext& frame, FrameWorkspace& work) {
    const bool may_have_lights = !frame.scene.moving_lights.empty() || !work.things.lanterns.empty();
    if (may_have_lights && frame.allows(Effect::Lights)) return false;
    find_styles(frame.allows(Effect::Styles), frame, work);
    work.surfaces.set_moving_lights({}, frame.view.eye);
    return true;
}

void find_light(const FrameContext& frame, FrameWorkspace& work) {
    const Claims& claims = work.claims;
    find_styles(claims.effects.has(Effect::Styles) || (!claims.things.meshes.empty() && frame.allows(Effect::Styles)),
                frame, work);
    if (!frame.allows(Effect::Lights))
        work.lights.clear();
    else
        gather_lights(frame, work);
    if (work.lights.empty() && !work.surfaces.has_moving_lights()) return;
    work.surfaces.set_moving_lights(work.lights, frame.view.eye);
    if (work.surfaces.has_moving_lights() && find_touched(work))
        work.claims.effects = work.claims.effects.with(Effect::Lights);
    else
        work.surfaces.set_moving_lights({}, frame.view.eye);
}

}  // namespace oblong
