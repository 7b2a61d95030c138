#include "game/view/shown_palette.h"

#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr Tint kTeleportFlash{{215, 220, 255}, 150};
constexpr std::int64_t kTeleportFlash_ms = 400;

// A tube's colours first: gamma is of the display that shows them.
std::optional<GammaTable> table_of(const Light& light) {
    if (!light.is_of_tube && light.gamma_100 == 100) return {};
    const GammaTable table = make_gamma_table(light.gamma_100);
    if (!light.is_of_tube) return table;
    GammaTable shown = make_tube_table();
    for (std::uint8_t& value : shown) value = table[value];
    return shown;
}

}  // namespace

void ShownPalette::note_tick(const GameState& before, const GameState& after) {
    if (was_teleported(before.player, after.player)) teleport_ms_ = time_ms_at({before, after});
}

PaletteEffects ShownPalette::effects_at(const GameView& view, Flashes flashes, const Light& light) {
    if (light != light_) gamma_ = table_of(light);
    light_ = light;
    PaletteEffects effects = palette_effects_at(data_.level, data_.effects, data_.palette, view.camera.eye, flashes);
    if (teleport_ms_ && flashes == Flashes::Full)
        effects.flash = faded(kTeleportFlash, time_ms_at(view.state) - *teleport_ms_, kTeleportFlash_ms);
    effects.gamma = gamma_;
    return effects;
}

}  // namespace oblong
