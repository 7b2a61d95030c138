#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/effects/palette_effects.h"
#include "engine/frame/frame.h"
#include "engine/scene/placed_models.h"
#include "engine/view/views.h"
#include "game/input/tick_input_source.h"
#include "game/level/load.h"
#include "game/options/preferences.h"
#include "game/simulation/game_level.h"

namespace oblong {

/// Two states one tick apart, and how far the picture is between them: 0 is the first, 65,536 the second.
struct InterpolatedState {
    const GameState& before;
    const GameState& after;
    std::int32_t fraction_16 = 0;

    World between(World in_before, World in_after) const;
    Vec3<World> between(const Vec3<World>& in_before, const Vec3<World>& in_after) const;
};

/// The contents of a picture: the game at a moment, and the camera.
struct GameView {
    InterpolatedState state;
    Camera camera;
    bool has_torch = false;              ///< a light at the eye
    std::optional<ViewSpec> other = {};  ///< drawn instead of the camera's view
};

ViewSpec spec_of(const GameView& view, const Settings& settings);

/// The time since the level began.
std::int64_t time_ms_at(const InterpolatedState& state);

/// The brush models that are drawn, with their offsets: without triggers, and without doors that turn.
std::vector<PlacedModel> placed_models(const GameLevel& level, const InterpolatedState& state);

/// The player's eye, turned further by `offset`.
Camera camera_at(const InterpolatedState& state, LookOffset offset, Degrees field_of_view);

/// The level's intermission, `ticks` after its end.
void show_intermission(const Intermission& intermission, std::int64_t ticks, Camera& camera);

/// The view drawn instead of the camera's, if a key asks for one. Isometric: from the south-west, the player in the
/// middle, without the level above. Zoomed: another field of view, with the eye moved so that the object in the middle
/// keeps its size; a front plane through the player cuts off what the eye has backed into. `zoom_degrees`: 0: none.
/// Nothing, too, for a view that cannot be drawn in the mode.
std::optional<ViewSpec> other_view(bool is_isometric, std::int32_t zoom_degrees, const Camera& camera,
                                   const ScreenMode& mode, const Level& level);

/// Moves and rolls the camera in walking, as Quake does, but in integers. Depends only on the states and the fraction
/// between them. The eye goes up and down once in 0.6 s, by at most 0.02 s times the speed, between 7 units below and 4
/// above its place; the view rolls by 2 degrees at 200 units a second sideways, and no further. Both are multiplied by
/// their preferences.
void sway(const InterpolatedState& state, const ComfortPreferences& preferences, Camera& camera);

/// The palette with which a game's pictures are shown: colour cycles, the tint of a liquid, a flash when the player
/// is teleported or hurt, gamma, and a VGA's 6 bits.
class ShownPalette {
  public:
    /// `data` outlives it.
    explicit ShownPalette(const GameData& data) : data_(data) {}

    /// Notes a tick: one that teleports or hurts the player starts a flash.
    void note_tick(const GameState& before, const GameState& after);
    /// The effects on the palette. The flash needs Flashes::Full.
    PaletteEffects effects_at(const GameView& view, Flashes flashes, const Light& light, bool has_dac6);

  private:
    const GameData& data_;
    Light light_;
    bool has_dac6_ = false;
    std::optional<GammaTable> channels_;  // of these settings; nothing if they change no colour
    Tint flash_;
    std::optional<std::int64_t> flash_ms_;  // when the player was teleported or hurt last
};

}  // namespace oblong
