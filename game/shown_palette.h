#pragma once

#include <optional>

#include "engine/effects/palette_effects.h"
#include "game/game_renderer.h"

namespace oblong {

/// The palette in which the pictures of a game are shown: cycles, the tint of a liquid, a flash after a teleporter, and
/// gamma.
class ShownPalette {
  public:
    /// `data` outlives it.
    explicit ShownPalette(const GameData& data) : data_(data) {}

    /// Notes a tick: one that teleports the player is the start of a flash.
    void note_tick(const GameState& before, const GameState& after);
    /// What is done to the palette. The flash is left out unless flashes are full. `gamma_100`: 50 to 200, 100 changes
    /// nothing.
    PaletteEffects effects_at(const GameView& view, Flashes flashes, std::int32_t gamma_100);

  private:
    const GameData& data_;
    std::int32_t gamma_100_ = 100;
    std::optional<GammaTable> gamma_;          // of gamma_100_; nothing where it changes nothing
    std::optional<std::int64_t> teleport_ms_;  // when the player was teleported last
};

}  // namespace oblong
