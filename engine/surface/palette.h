#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace oblong {

struct Rgb8 {
    std::uint8_t red = 0, green = 0, blue = 0;
    constexpr bool operator==(const Rgb8&) const = default;
};

/// A channel in the 6 bits of a VGA DAC.
constexpr std::uint8_t narrow_dac6(std::uint8_t channel) {
    return static_cast<std::uint8_t>(channel >> 2);
}
/// The channel shown for 6 bits: 0 is 0, 63 is 255.
constexpr std::uint8_t widen_dac6(std::uint8_t six_bits) {
    return static_cast<std::uint8_t>(six_bits << 2 | six_bits >> 4);
}

/// Colours from here on are fullbright: light does not change them.
inline constexpr int kFirstFullbright = 224;

struct Palette {
    std::array<Rgb8, 256> colours{};
};

/// A palette from 768 bytes of red, green, blue triples (Quake's palette.lmp). Throws InputError for any other size.
Palette read_palette(std::span<const std::uint8_t> bytes);

/// 6 x 6 x 6 even colours, then black.
Palette even_colours();

/// Luminance of a colour times 1,000 (weights of ITU-R BT.601).
constexpr std::int32_t luminance_1000(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

/// Palette indices [begin, end).
struct ColourRange {
    int begin = 0, end = 256;
};
inline constexpr ColourRange kOrdinaryColours{0, kFirstFullbright};

/// The index in `range` of the nearest colour (least sum of squared differences of red, green and blue); the lowest of
/// several.
std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range = {});

}  // namespace oblong
