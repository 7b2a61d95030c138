#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/scene/level_effects.h"
#include "engine/surface/palette.h"

namespace oblong {

// Effects on the palette only: no pixel is read or written.

/// The most steps a second of a cycle if flashes are reduced. WCAG 2.2, success criterion 2.3.1, allows three flashes a
/// second; a flash is a pair of opposite changes, so this is half of that.
inline constexpr auto kReducedCycleRate = PaletteCycle::Rate::from_int(3);

/// A colour mixed into all others with a share of share_256 / 256.
struct Tint {
    Rgb8 colour;
    std::int32_t share_256 = 0;
    bool operator==(const Tint&) const = default;
};

/// The tint of the view from inside a liquid (`contents` of the eye's leaf): the mean colour of the level's first
/// texture of this kind, or Quake's colour if there is none; with Quake's shares.
Tint liquid_tint(std::int32_t contents, const Level& level, const Palette& palette);

/// A tint that fades linearly to nothing in `duration_ms` (> 0), `elapsed_ms` (>= 0) after it began.
Tint faded(const Tint& tint, std::int64_t elapsed_ms, std::int64_t duration_ms);

/// The brightness shown for each value of a channel.
using GammaTable = std::array<std::uint8_t, 256>;
/// v^(100 / gamma_100) for v of 0 to 1; gamma_100 is 50 to 200, above 100 brightens dark colours.
GammaTable make_gamma_table(std::int32_t gamma_100);

/// The response of a tube, for an sRGB display. A tube's light is a (v + b)^2.4 (ITU-R BT.1886, annex 1), where a and b
/// follow from its white, 1, and its black, kTubeBlack_per_cent. The black is subtracted, as eyes adapt to it, and the
/// rest is encoded as sRGB (IEC 61966-2-1). 0 and 255 stay; dark colours become brighter.
GammaTable make_tube_table();
/// The black of a tube, in percent of its white: 1 % for the room's light on the glass, as in sRGB, and 1 % from the
/// brightness control. So colours of 4 to 24 of 255 are between GLQuake's palette (v^0.7: Check_Gamma in gl_vidnt.c)
/// and vkQuake's default ((1.4 v)^0.9).
inline constexpr std::int32_t kTubeBlack_per_cent = 2;

/// Changes to a palette, applied in this order.
struct PaletteEffects {
    std::vector<PaletteCycle> cycles;
    Tint liquid, flash;
    std::optional<GammaTable> gamma;

    /// Whether there are none.
    bool is_plain() const { return cycles.empty() && liquid.share_256 == 0 && flash.share_256 == 0 && !gamma; }
};

/// The cycles of a level, and the tint of the liquid at the eye. Cycles are limited to kReducedCycleRate if flashes are
/// reduced, and stopped if they are off.
PaletteEffects palette_effects_at(const Level& level, const LevelEffects& effects, const Palette& palette,
                                  const Vec3<World>& eye, Flashes flashes);

/// The palette at time_ms >= 0.
Palette apply_palette_effects(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms);

}  // namespace oblong
