#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/scene/level_effects.h"
#include "engine/surface/palette.h"

namespace oblong {

/// Effects on the 256 colours that a picture is shown in: no pixel is read or written for them.

/// The most steps a second of a cycle if flashes are reduced. WCAG 2.2, success criterion 2.3.1: three flashes a second
/// at most. A flash is a change and the opposite one, so that this is half of it.
inline constexpr auto kReducedCycleRate = PaletteCycle::Rate::from_int(3);

/// A colour mixed into all others: of 256 parts, `share_256` are of it.
struct Tint {
    Rgb8 colour;
    std::int32_t share_256 = 0;
    bool operator==(const Tint&) const = default;
};

/// That of all that is seen from inside a liquid (`contents` of the eye's leaf): the mean colour of the level's first
/// texture of its kind, in Quake's shares. Where the level has none, Quake's colours.
Tint liquid_tint(std::int32_t contents, const Level& level, const Palette& palette);

/// What is left of a tint that fades to nothing within `duration_ms` (above 0), `elapsed_ms` (from 0) after it began.
Tint faded(const Tint& tint, std::int64_t elapsed_ms, std::int64_t duration_ms);

/// The brightness shown for each value of a channel.
using GammaTable = std::array<std::uint8_t, 256>;
/// A value v of 0 to 1 is shown as v^(100 / gamma_100): above 100, 50 to 200, dark colours are brighter.
GammaTable make_gamma_table(std::int32_t gamma_100);

/// What a tube made of each value, for a display that follows sRGB. A tube's light is a (v + b)^2.4 (ITU-R BT.1886,
/// annex 1); its white is 1 and its black kTubeBlack, from which a and b follow. That black is taken off, since eyes
/// adapt to it, and the rest is encoded as sRGB (IEC 61966-2-1). 0 and 255 stay; dark colours are brighter.
GammaTable make_tube_table();
/// The black of a tube, of its white: the 1 % that sRGB counts for the room's light on the glass, and as much again
/// from a knob that is turned up until the dark shows. So colours of 4 to 24 of 255 come out between what GLQuake does
/// to its palette (v^0.7: Check_Gamma in gl_vidnt.c) and what vkQuake does by default ((1.4 v)^0.9).
inline constexpr std::int32_t kTubeBlack_per_cent = 2;

/// What is done to a palette, in this order.
struct PaletteEffects {
    std::vector<PaletteCycle> cycles;
    Tint liquid, flash;
    std::optional<GammaTable> gamma;

    /// Whether nothing is done.
    bool is_plain() const;
};

/// What a level and the place of the eye call for: cycles, and the tint of a liquid. Cycles go at kReducedCycleRate at
/// most if flashes are reduced, and stand still if they are off.
PaletteEffects palette_effects_at(const Level& level, const LevelEffects& effects, const Palette& palette,
                                  const Vec3<World>& eye, Flashes flashes);

/// The palette that shows a picture at a time from 0 on; a pure function of its arguments.
Palette apply_palette_effects(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms);

}  // namespace oblong
