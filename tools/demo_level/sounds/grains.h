#pragma once

#include <initializer_list>

#include "tools/demo_level/sounds/synth.h"

/// Short sounds that others are put together from.
namespace oblong::synth {

/// A way in which a struck thing rings.
struct Mode {
    std::int32_t hz, half_life_ms, percent;
};

/// One of many short sounds: where, how loud and how it is. Made as Grain{chance.between(...), ...}: braces draw in
/// order, while the arguments of a call are drawn in an order that differs from compiler to compiler.
struct Grain {
    std::int32_t at_ms, percent, hz, length_ms = 0;
};

/// A strike: a burst of noise, the higher `brightness_hz` the harder.
Samples strike(std::int32_t ms, std::int32_t half_life_ms, std::int32_t brightness_hz, std::uint32_t seed);

/// All modes of a thing that is struck, each frequency times `pitch_percent`.
Samples struck(const Samples& strike, std::initializer_list<Mode> modes, std::int32_t pitch_percent = 100);

/// A bubble that bursts: a tone that rises.
Samples bubble(std::int32_t ms, std::int32_t hz);

}  // namespace oblong::synth
