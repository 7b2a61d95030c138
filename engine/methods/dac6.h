#pragma once

#include <cstdint>

#include "engine/surface/palette.h"

namespace oblong {

/// A VGA's converter (DAC) has 6 bits a channel. Widening repeats the top bits, so that 0 stays 0 and 63 becomes 255.
constexpr std::uint8_t widen_dac6(std::uint8_t six_bits) {
    return static_cast<std::uint8_t>(six_bits << 2 | six_bits >> 4);
}
/// narrow_dac6(widen_dac6(v)) == v for every v of 6 bits.
constexpr std::uint8_t narrow_dac6(std::uint8_t eight_bits) {
    return static_cast<std::uint8_t>(eight_bits >> 2);
}

/// The palette as a VGA shows it: each channel through 6 bits.
Palette as_shown_by_dac6(const Palette& palette);

}  // namespace oblong
