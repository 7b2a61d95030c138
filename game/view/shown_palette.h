#pragma once

#include <optional>

#include "engine/effects/palette_effects.h"
#include "game/options/preferences.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// The palette with which a game's pictures are shown: colour cycles, the tint of a liquid, a flash after a teleporter,
/// gamma, and a VGA's 6 bits.
class ShownPalette {
  public:
    /// `data` outlives it.
    explicit ShownPalette(const GameData& data) : data_(data) {}

    /// Notes a tick: one that teleports the player starts a flash.
    void note_tick(const GameState& before, const GameState& after);
    /// The effects on the palette. The flash needs Flashes::Full.
    PaletteEffects effects_at(const GameView& view, Flashes flashes, const Light& light, bool has_dac6);

  private:
    const GameData& data_;
    Light light_;
    bool has_dac6_ = false;
    std::optional<GammaTable> channels_;       // of these settings; nothing if they change no colour
    std::optional<std::int64_t> teleport_ms_;  // when the player was teleported last
};

}  // namespace oblong
