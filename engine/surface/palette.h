#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace oblong {

struct Rgb8 {
    std::uint8_t red = 0, green = 0, blue = 0;
    constexpr bool operator==(const Rgb8&) const = default;
};

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

/// Shade x colour -> colour. Shade 0 is the colour itself, 63 the darkest; luminance never rises with the shade.
struct Colormap {
    static constexpr int kShades = 64;
    std::array<std::array<std::uint8_t, 256>, kShades> shades{};
};

/// The colormap of a palette: the palette entry nearest to the colour times (63 - shade) / 63. The last
/// `fullbright_count` colours glow: they are the same in every shade, and no other colour becomes one (Quake's last
/// 32).
Colormap make_colormap(const Palette& palette, int fullbright_count = 32);

/// The colormap with only `count` different shades, 2 to 64, from full light to the darkest: each of 64 is replaced by
/// the next brighter one of them.
Colormap with_shades(const Colormap& colormap, std::int32_t count);

}  // namespace oblong
