#include "engine/effects/things_in_view.h"

#include <optional>
#include <span>

namespace oblong {

namespace {

void add_sprite(const Sprite& sprite, const Level& level, const ViewContext& view, ThingsInView& in_view,
                DepthBuffer& depth) {
    const std::optional<ScreenSprite> screen = project_sprite(sprite, level.textures[sprite.texture], view);
    if (!screen) return;
    in_view.sprites.push_back({*screen, sprite.position});
    depth.want(screen->pixels);
}

}  // namespace

void find_particles(const Things& things, std::int64_t time_ms, const Sight& sight, ThingsInView& in_view,
                    DepthBuffer& depth) {
    for (const PlacedEmitter& placed : things.emitters) {
        if (!may_be_seen(placed.place, sight.visible, sight.view)) continue;
        const std::size_t first = in_view.dots.size();
        append_dots(placed.emitter, time_ms, sight.view, in_view.dots);
        in_view.particles_computed += placed.emitter.count;
        const std::span<const ParticleDot> dots = std::span(in_view.dots).subspan(first);
        if (dots.empty()) continue;
        in_view.emitters.push_back({first, dots.size(), placed.emitter.middle});
        depth.want(rectangle_around(dots));
    }
}

void find_sprites(const Things& things, std::int64_t time_ms, const Level& level, const Sight& sight,
                  ThingsInView& in_view, DepthBuffer& depth) {
    for (const PlacedSprite& placed : things.sprites)
        if (may_be_seen(placed.place, sight.visible, sight.view))
            add_sprite(placed.sprite, level, sight.view, in_view, depth);
    for (const PlacedLantern& placed : things.lanterns)
        if (may_be_seen(placed.place, sight.visible, sight.view))
            add_sprite(lantern_at(placed.lantern, time_ms), level, sight.view, in_view, depth);
}

void find_shadows(const Things& things, const Sight& sight, ThingsInView& in_view) {
    for (const PlacedSprite& placed : things.sprites)
        if (placed.floor && may_be_seen(placed.place, sight.visible, sight.view))
            in_view.shadows.push_back(make_shadow(*placed.floor, placed.sprite.position, placed.shadow_radius));
}

}  // namespace oblong
