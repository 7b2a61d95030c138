#include "game/view/shown_view.h"

#include <algorithm>

#include "engine/fixed/trig.h"
#include "engine/level/trace.h"
#include "engine/math/basis.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

/// Of the isometric view: its width in units, and how far above the eye the level is cut off.
constexpr View kIsometricWidth = View::from_int(1024);
constexpr World kSectionAboveEye = World::from_int(40);

/// The distance of the surface in the middle of the picture, 16 to 4,096 units.
World distance_ahead(const Camera& camera, const Level& level) {
    constexpr World kNearest = World::from_int(16), kFarthest = World::from_int(4096);
    const Vec3<Unit> forward = view_basis(camera.yaw, camera.pitch, camera.roll).forward;
    const auto far_along = [&](World from, Unit component) {
        return saturating_convert<World>(convert<WorldWide>(from) + product<WorldWide>(kFarthest, component));
    };
    const Vec3<World> far{far_along(camera.eye.x, forward.x), far_along(camera.eye.y, forward.y),
                          far_along(camera.eye.z, forward.z)};
    const TraceResult hit = trace_hull(level, level.world(), Hull::Point, camera.eye, far);
    return std::clamp(product<World>(kFarthest, hit.fraction), kNearest, kFarthest);
}

ViewSpec isometric_view(const Camera& camera) {
    ViewSpec view = orthographic_view(camera.eye, axonometric_axes(Axonometry::Isometric), kIsometricWidth);
    cut_above(view, saturating_convert<World>(convert<WorldWide>(camera.eye.z) + convert<WorldWide>(kSectionAboveEye)));
    return view;
}

/// The eye goes back no farther than the room does: the field of view is then the narrowest from there.
ViewSpec zoomed_view(const Camera& camera, std::int32_t zoom_degrees, const Level& level) {
    constexpr auto kDegree = Degrees::from_int(1);
    const World ahead = distance_ahead(camera, level);
    const auto zoomed = [&](Degrees zoom) { return dolly_zoomed(camera, ahead, zoom); };
    const auto is_in_room = [&](const Camera& from) {
        return !trace_hull(level, level.world(), Hull::Point, camera.eye, from.eye).is_hit;
    };
    Degrees zoom = Degrees::from_int(zoom_degrees);
    while (zoom < camera.field_of_view && !is_in_room(zoomed(zoom)))
        zoom = std::min(zoom + kDegree, camera.field_of_view);
    return first_person_view(zoomed(zoom));
}

constexpr std::int64_t kCycle_ticks = 21;  // 0.6 s
static_assert(kCycle_ticks * 10 == 6 * kTicksPerSecond);
constexpr World kHighest = World::from_int(4), kLowest = World::from_int(-7);
constexpr World kRollSpeed = World::from_int(200);  // at which the roll is kRoll
constexpr std::int64_t kRoll = 364;                 // 2 degrees, 65,536 to the circle

Velocity velocity_at(const InterpolatedState& state) {
    const Velocity &before = state.before.player.velocity, &after = state.after.player.velocity;
    return before + scaled(after - before, state.fraction_16, 65'536);
}

// 0.02 s times the speed: three tenths constant, seven tenths times a sine.
World bob(World speed, const InterpolatedState& state) {
    const std::int64_t ticks_16 = (state.before.tick % kCycle_ticks << 16) + state.fraction_16;
    const Unit wave = sine(Angle::from_bam(ticks_16 / kCycle_ticks));
    const World most = scaled(speed, 2, 100);
    return std::clamp(scaled(most, 3, 10) + times(scaled(most, 7, 10), wave), kLowest, kHighest);
}

std::int64_t roll_of(World sideways) {
    return std::int64_t{floor_of<12>(std::clamp(sideways, -kRollSpeed, kRollSpeed))} * kRoll / floor_of<12>(kRollSpeed);
}

}  // namespace

World InterpolatedState::between(World in_before, World in_after) const {
    const auto fraction = Fixed<std::int32_t, 16>::from_raw(fraction_16);
    return in_before +
           convert<World>(bounded_product(widening_difference(in_after, in_before), fraction), Rounding::Floor);
}

Vec3<World> InterpolatedState::between(const Vec3<World>& in_before, const Vec3<World>& in_after) const {
    return {between(in_before.x, in_after.x), between(in_before.y, in_after.y), between(in_before.z, in_after.z)};
}

ViewSpec spec_of(const GameView& view, const Settings& settings) {
    return view.other ? *view.other : first_person_view(view.camera, settings.accuracy.sine);
}

std::int64_t time_ms_at(const InterpolatedState& state) {
    const std::int64_t ticks_16 = (state.before.tick << 16) + state.fraction_16;
    return ticks_16 * 1000 / kTicksPerSecond >> 16;
}

std::vector<PlacedModel> placed_models(const GameLevel& level, const InterpolatedState& state) {
    std::vector<PlacedModel> placed;
    for (std::size_t i = 0; i < level.movers.size(); ++i) {
        const Mover& mover = level.movers[i];
        if (is_removed(state.after.movers[i]) || mover.turns != 0) continue;
        const Vec3<World> before = offset_of(mover, state.before.movers[i]),
                          after = offset_of(mover, state.after.movers[i]);
        placed.push_back({mover.model, state.between(before, after), shows_other_frames(mover, state.after.movers[i])});
    }
    for (std::size_t i = 0; i < level.walls.size(); ++i) {
        const WallState wall = state.after.walls[i];
        if (wall != WallState::Removed) placed.push_back({level.walls[i], {}, wall == WallState::ShowsOtherFrames});
    }
    return placed;
}

Camera camera_at(const InterpolatedState& state, LookOffset offset, Degrees field_of_view) {
    const Player& player = state.after.player;
    const Position before = eye_of(state.before.player), after = eye_of(player);
    Camera camera;
    camera.eye = was_teleported(state.before.player, player) ? after : state.between(before, after);
    camera.yaw = player.yaw + Angle::from_bam(offset.yaw);
    camera.pitch =
        Angle::from_bam(std::clamp(player.pitch + offset.pitch, -Player::kSteepestPitch, Player::kSteepestPitch));
    camera.field_of_view = field_of_view;
    return camera;
}

void show_intermission(const Intermission& intermission, std::int64_t ticks, Camera& camera) {
    camera.eye = intermission.eye;
    camera.pitch = intermission.pitch;
    camera.yaw =
        intermission.yaw + Angle::from_bam(intermission.turn_degrees * ticks * 65'536 / (360 * kTicksPerSecond));
}

std::optional<ViewSpec> other_view(bool is_isometric, std::int32_t zoom_degrees, const Camera& camera,
                                   const ScreenMode& mode, const Level& level) {
    if (!is_isometric && zoom_degrees == 0) return std::nullopt;
    const ViewSpec view = is_isometric ? isometric_view(camera) : zoomed_view(camera, zoom_degrees, level);
    return problem_of(view, mode) ? std::nullopt : std::optional(view);
}

void sway(const InterpolatedState& state, const ComfortPreferences& preferences, Camera& camera) {
    Velocity velocity = velocity_at(state);
    velocity.z = {};
    if (preferences.view_bob_100 != 0)
        camera.eye.z = camera.eye.z + scaled(bob(length_of(velocity), state), preferences.view_bob_100, 100);
    if (preferences.view_roll_100 == 0) return;
    const World sideways = component_along(velocity, view_basis(camera.yaw, {}, {}).right);
    camera.roll = Angle::from_bam(roll_of(sideways) * preferences.view_roll_100 / 100);
}

namespace {

constexpr Tint kTeleportFlash{{215, 220, 255}, 150}, kHurtFlash{{170, 0, 0}, 80};
constexpr std::int64_t kFlash_ms = 400;

// Order: the colours of a tube, then the gamma of the display, then the VGA's 6 bits.
std::optional<GammaTable> channels_of(const Light& light, bool has_dac6) {
    if (!light.is_of_tube && light.gamma_100 == 100 && !has_dac6) return {};
    GammaTable shown = make_gamma_table(light.gamma_100);
    if (light.is_of_tube) {
        const GammaTable gamma = shown;
        shown = make_tube_table();
        for (std::uint8_t& value : shown) value = gamma[value];
    }
    if (has_dac6)
        for (std::uint8_t& value : shown) value = widen_dac6(narrow_dac6(value));
    return shown;
}

}  // namespace

void ShownPalette::note_tick(const GameState& before, const GameState& after) {
    const bool is_hurt = after.harm.damage > before.harm.damage;
    if (!is_hurt && !was_teleported(before.player, after.player)) return;
    flash_ = is_hurt ? kHurtFlash : kTeleportFlash;
    flash_ms_ = time_ms_at({before, after});
}

PaletteEffects ShownPalette::effects_at(const GameView& view, Flashes flashes, const Light& light, bool has_dac6) {
    if (light != light_ || has_dac6 != has_dac6_) channels_ = channels_of(light, has_dac6);
    light_ = light;
    has_dac6_ = has_dac6;
    PaletteEffects effects = palette_effects_at(data_.level, data_.effects, data_.palette, view.camera.eye, flashes);
    if (flash_ms_ && flashes == Flashes::Full)
        effects.flash = faded(flash_, time_ms_at(view.state) - *flash_ms_, kFlash_ms);
    effects.gamma = channels_;
    return effects;
}

}  // namespace oblong
