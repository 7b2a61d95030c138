#include "engine/effects/things_in_view.h"

#include <optional>
#include <span>

namespace oblong {

namespace {

void add_emitter(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view, ThingsInView& in_view,
                 DepthBuffer& depth) {
    const std::size_t first = in_view.dots.size();
    append_dots(emitter, time_ms, view, in_view.dots);
    in_view.particles_computed += emitter.count;
    depth.want(rectangle_around(std::span(in_view.dots).subspan(first)));
}

void add_sprite(const Sprite& sprite, const Level& level, const ViewContext& view, ThingsInView& in_view,
                DepthBuffer& depth) {
    const std::optional<ScreenSprite> screen = project_sprite(sprite, level.textures[sprite.texture], view);
    if (!screen) return;
    in_view.sprites.push_back({*screen, sprite.position});
    depth.want(screen->pixels);
}

}  // namespace

void find_things_in_view(const Things& things, std::int64_t time_ms, const Level& level, const VisibleSet& visible,
                         const ViewContext& view, ThingsInView& in_view, DepthBuffer& depth) {
    in_view.dots.clear();
    in_view.sprites.clear();
    in_view.shadows.clear();
    in_view.particles_computed = 0;
    for (const PlacedEmitter& placed : things.emitters)
        if (may_be_seen(placed.place, visible, view)) add_emitter(placed.emitter, time_ms, view, in_view, depth);
    for (const PlacedSprite& placed : things.sprites) {
        if (!may_be_seen(placed.place, visible, view)) continue;
        add_sprite(placed.sprite, level, view, in_view, depth);
        if (placed.floor)
            in_view.shadows.push_back(make_shadow(*placed.floor, placed.sprite.position, placed.shadow_radius));
    }
    for (const PlacedLantern& placed : things.lanterns)
        if (may_be_seen(placed.place, visible, view))
            add_sprite(lantern_at(placed.lantern, time_ms), level, view, in_view, depth);
}

}  // namespace oblong
