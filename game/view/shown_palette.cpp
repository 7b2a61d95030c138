#include "game/view/shown_palette.h"

#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr Tint kTeleportFlash{{215, 220, 255}, 150};
constexpr std::int64_t kTeleportFlash_ms = 400;

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
    if (was_teleported(before.player, after.player)) teleport_ms_ = time_ms_at({before, after});
}

PaletteEffects ShownPalette::effects_at(const GameView& view, Flashes flashes, const Light& light, bool has_dac6) {
    if (light != light_ || has_dac6 != has_dac6_) channels_ = channels_of(light, has_dac6);
    light_ = light;
    has_dac6_ = has_dac6;
    PaletteEffects effects = palette_effects_at(data_.level, data_.effects, data_.palette, view.camera.eye, flashes);
    if (teleport_ms_ && flashes == Flashes::Full)
        effects.flash = faded(kTeleportFlash, time_ms_at(view.state) - *teleport_ms_, kTeleportFlash_ms);
    effects.gamma = channels_;
    return effects;
}

}  // namespace oblong
