#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace oblong {

struct Rgb8 {
    std::uint8_t red = 0, green = 0, blue = 0;
    constexpr bool operator==(const Rgb8&) const = default;
};

/// A channel as a VGA's converter (DAC) keeps it, in 6 bits.
constexpr std::uint8_t narrow_dac6(std::uint8_t channel) {
    return static_cast<std::uint8_t>(channel >> 2);
}
/// What the 6 bits of a VGA's channel show: 0 is 0, and 63 is 255.
constexpr std::uint8_t widen_dac6(std::uint8_t six_bits) {
    return static_cast<std::uint8_t>(six_bits << 2 | six_bits >> 4);
}

/// The last 32 colours of a palette glow: light does not change them.
inline constexpr int kFirstFullbright = 224;

/// The 256 colours of a picture.
struct Palette {
    std::array<Rgb8, 256> colours{};
};

/// A palette from 768 bytes of red, green, blue triples (Quake's palette.lmp). Throws InputError for any other size.
Palette read_palette(std::span<const std::uint8_t> bytes);

/// Luminance of a colour times 1,000, by the weights of the standard for television (ITU-R BT.601).
constexpr std::int32_t luminance_1000(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

/// A range of palette indices, `end` not included.
struct ColourRange {
    int begin = 0, end = 256;
};
inline constexpr ColourRange kOrdinaryColours{0, kFirstFullbright};

/// The index in `range` whose colour is nearest (squares of the differences of red, green and blue added up); the
/// lowest of several.
std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range = {});

}  // namespace oblong
