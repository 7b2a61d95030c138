#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace oblong {

struct Rgb8 {
    std::uint8_t red = 0, green = 0, blue = 0;
    constexpr bool operator==(const Rgb8&) const = default;
};

/// The last 32 colours of a palette glow: light does not change them.
inline constexpr int kFirstFullbright = 224;

/// The 256 colours of a picture.
struct Palette {
    std::array<Rgb8, 256> colours{};
};

/// A palette from 768 bytes of red, green, blue triples (Quake's palette.lmp). Throws InputError for any other size.
Palette read_palette(std::span<const std::uint8_t> bytes);

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

/// Luminance of a colour times 1,000, by the weights of the standard for television (ITU-R BT.601).
constexpr std::int32_t luminance_1000(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

}  // namespace oblong
