#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/level/level.h"
#include "engine/surface/palette.h"

namespace oblong {

/// Effects on the 256 colours that a picture is shown in: no pixel is read or written for them.

/// Colours `first` to `last` that move round in their places: `last` to `first` and all others one place up at each
/// step. Steps a second have 16 fraction bits, and are negative for the other direction.
struct PaletteCycle {
    std::int32_t first = 0, last = 0;
    std::int32_t steps_per_second_16 = 0;  ///< within kMostCycleSteps << 16
    bool operator==(const PaletteCycle&) const = default;
};
inline constexpr std::int32_t kMostCycleSteps = 100, kMostPaletteCycles = 16;

/// The cycles that a worldspawn's keys palette_cycle, palette_cycle2 and so on to palette_cycle16 ask for, "FIRST LAST
/// STEPS_PER_SECOND" each. Throws InputError for any other value.
std::vector<PaletteCycle> read_palette_cycles(const Entity& worldspawn);

/// A colour mixed into all others: of 256 parts, `share_256` are of it.
struct Tint {
    Rgb8 colour;
    std::int32_t share_256 = 0;
    bool operator==(const Tint&) const = default;
};

/// Quake's, of all that is seen from inside a liquid (`contents` of the eye's leaf), when hurt, and on a pickup.
Tint liquid_tint(std::int32_t contents);
inline constexpr Tint kDamageFlash{{255, 0, 0}, 150}, kPickupFlash{{215, 186, 69}, 50};

/// What is left of a tint that fades to nothing within `duration_ms` (above 0), `elapsed_ms` (from 0) after it began.
Tint faded(const Tint& tint, std::int64_t elapsed_ms, std::int64_t duration_ms);

/// The brightness shown for each value of a channel.
using GammaTable = std::array<std::uint8_t, 256>;
/// A value v of 0 to 1 is shown as v^(100 / gamma_100): above 100, 50 to 200, dark colours are brighter.
GammaTable make_gamma_table(std::int32_t gamma_100);

/// What is done to a palette, in this order.
struct PaletteEffects {
    std::vector<PaletteCycle> cycles;
    Tint liquid, damage, pickup, fade;
    std::optional<GammaTable> gamma;

    /// Whether nothing is done.
    bool is_plain() const;
};

/// The palette that shows a picture at a time from 0 on; a pure function of its arguments.
Palette apply_palette_effects(const Palette& palette, const PaletteEffects& effects, std::int64_t time_ms);

}  // namespace oblong
