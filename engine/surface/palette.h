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

}  // namespace oblong
