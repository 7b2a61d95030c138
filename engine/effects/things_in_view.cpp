#include "engine/effects/things_in_view.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace oblong {

namespace {

/// How often an emitter's box is halved: particles cost more than tests of its parts.
constexpr int kCuts = 4;

/// Removes the dots from `first` on that are outside the part of the screen that is drawn.
void keep_dots_in(const ScreenRectangle& part, std::size_t first, std::vector<ParticleDot>& dots) {
    const auto is_outside = [&part](const ParticleDot& dot) {
        return !overlap({dot.first_column, dot.end_column, dot.first_row, dot.end_row}, part);
    };
    dots.erase(std::remove_if(dots.begin() + static_cast<std::ptrdiff_t>(first), dots.end(), is_outside), dots.end());
}

/// The two halves of a box, divided along its longest axis.
std::array<LevelBox, 2> halves_of(const LevelBox& box) {
    const auto size = [&box](std::size_t axis) { return box.maxs[axis] - box.mins[axis]; };
    const std::size_t across = size(0) >= size(1) ? 0 : 1, longest = size(across) >= size(2) ? across : 2;
    LevelBox low = box, high = box;
    low.maxs[longest] = high.mins[longest] = box_coordinate(box.mins[longest] + size(longest) / 2);
    return {low, high};
}

/// False if the box, or each part after halving it `cuts` times, is hidden.
bool may_show_in_halves(const LevelBox& box, int cuts, const Sight& sight) {
    if (!sight.may_show(box)) return false;
    if (cuts == 0) return true;
    const auto [low, high] = halves_of(box);
    return may_show_in_halves(low, cuts - 1, sight) || may_show_in_halves(high, cuts - 1, sight);
}

InverseDepth nearest_inverse_depth(const ScreenSprite& sprite) {
    const std::int64_t rows = sprite.pixels.end_row - sprite.pixels.first_row;
    const std::int64_t last_16 = sprite.inverse_depth_16 + rows * sprite.inverse_depth_step_16;
    return static_cast<InverseDepth>(std::max(sprite.inverse_depth_16, last_16) >> 16);
}

InverseDepth nearest_inverse_depth(std::span<const ParticleDot> dots) {
    InverseDepth nearest = 0;
    for (const ParticleDot& dot : dots) nearest = std::max(nearest, dot.inverse_depth);
    return nearest;
}

void add_sprite(const Sprite& sprite, const Level& level, const Sight& sight, ThingsInView& in_view,
                DepthBuffer& depth) {
    const std::optional<ScreenSprite> screen = project_sprite(sprite, level.textures[sprite.texture], sight.view);
    if (!screen || (sight.drawn_part && !overlap(screen->pixels, *sight.drawn_part))) return;
    if (!sight.may_show(screen->pixels, nearest_inverse_depth(*screen))) return;
    in_view.sprites.push_back({*screen, sprite.position});
    depth.want(screen->pixels);
}

}  // namespace

void find_particles(const Things& things, std::int64_t time_ms, const Sight& sight, ThingsInView& in_view,
                    DepthBuffer& depth) {
    for (const PlacedEmitter& placed : things.emitters) {
        if (!sight.may_show(placed.place) || !may_show_in_halves(placed.place.box, kCuts, sight)) continue;
        const std::size_t first = in_view.dots.size();
        append_dots(placed.emitter, time_ms, sight.view, in_view.dots);
        in_view.particles_computed += placed.emitter.count;
        if (sight.drawn_part) keep_dots_in(*sight.drawn_part, first, in_view.dots);
        const std::span<const ParticleDot> dots = std::span(in_view.dots).subspan(first);
        const ScreenRectangle pixels = rectangle_around(dots);
        if (dots.empty() || !sight.may_show(pixels, nearest_inverse_depth(dots))) {
            in_view.dots.resize(first);
            continue;
        }
        in_view.emitters.push_back(
            {first, dots.size(), placed.emitter.middle, World::from_int(placed.place.box.mins[2])});
        depth.want(pixels);
    }
}

void find_sprites(const Things& things, std::int64_t time_ms, const Level& level, const Sight& sight,
                  ThingsInView& in_view, DepthBuffer& depth) {
    for (const PlacedSprite& placed : things.sprites)
        if (sight.may_show(placed.place)) add_sprite(placed.sprite, level, sight, in_view, depth);
    for (const PlacedLantern& placed : things.lanterns)
        if (sight.may_show(placed.place)) add_sprite(lantern_at(placed.lantern, time_ms), level, sight, in_view, depth);
}

void find_shadows(const Things& things, const Sight& sight, ThingsInView& in_view) {
    for (const PlacedSprite& placed : things.sprites)
        if (placed.floor && sight.may_show(placed.place))
            in_view.shadows.push_back(make_shadow(*placed.floor, placed.sprite.position, placed.shadow_radius));
}

}  // namespace oblong
