#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/surface/palette.h"

namespace oblong::art {

/// A run of the palette from dark to bright in one hue. Those from Flame on glow.
enum class Ramp : std::uint8_t {
    Grey,
    Stone,
    Sand,
    Wood,
    Brass,
    Verdigris,
    Night,
    Water,
    Red,
    Terracotta,
    Ivory,
    Violet,
    Moss,
    Flame,
    Ice,
    Magenta,
    Green,
    Cyan,
    Hole  ///< index 255, seen through where a texture's name begins with '{'
};

struct RampPlace {
    int first = 0, count = 16;  ///< palette indices
};

inline constexpr int kOrdinaryRamps = 13, kRampSteps = 16;

/// Colours halfway between some steps of a ramp, for what is flat and large: light falls on it in steps half as high.
struct HalfSteps {
    Ramp ramp;
    int first, count;  ///< the first lies between the steps `first` and `first` + 1
};
inline constexpr std::array<HalfSteps, 2> kHalfSteps{{{Ramp::Ivory, 2, 8}, {Ramp::Night, 1, 8}}};

constexpr RampPlace place_of(Ramp ramp) {
    constexpr std::array<RampPlace, 6> kGlowing{{{224, 8}, {232, 8}, {240, 4}, {244, 4}, {248, 4}, {255, 1}}};
    const int index = static_cast<int>(ramp);
    if (index < kOrdinaryRamps) return {index * kRampSteps, kRampSteps};
    return at(kGlowing, index - kOrdinaryRamps);
}

/// The colours of the exhibits' lenses, in the order of a visit and of the rainbow.
inline constexpr std::array<Ramp, 12> kLensRamps{Ramp::Red,  Ramp::Terracotta, Ramp::Flame,     Ramp::Brass,
                                                 Ramp::Moss, Ramp::Green,      Ramp::Verdigris, Ramp::Cyan,
                                                 Ramp::Ice,  Ramp::Water,      Ramp::Night,     Ramp::Violet};

/// The palette of the demo level: thirteen ramps of sixteen steps that begin near black (index 0 is black), then half
/// steps, then 32 colours that glow. No colour appears twice.
Palette design_palette();

}  // namespace oblong::art
