#include "game/shown_palette.h"

namespace oblong {
namespace {

constexpr Tint kTeleportFlash{{215, 220, 255}, 150};
constexpr std::int64_t kTeleportFlash_ms = 400;

}  // namespace

void ShownPalette::note_tick(const GameState& before, const GameState& after) {
    if (was_teleported(before.player, after.player)) teleport_ms_ = time_ms_at({before, after});
}

PaletteEffects ShownPalette::effects_at(const GameView& view, Flashes flashes, std::int32_t gamma_100) {
    if (gamma_100 != gamma_100_) gamma_ = gamma_100 == 100 ? std::nullopt : std::optional(make_gamma_table(gamma_100));
    gamma_100_ = gamma_100;
    PaletteEffects effects = palette_effects_at(data_.level, data_.effects, data_.palette, view.camera.eye, flashes);
    if (teleport_ms_ && flashes == Flashes::Full)
        effects.flash = faded(kTeleportFlash, time_ms_at(view.state) - *teleport_ms_, kTeleportFlash_ms);
    effects.gamma = gamma_;
    return effects;
}

}  // namespace oblong
