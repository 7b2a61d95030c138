#include "engine/surface/palette.h"

#include <limits>
#include <string>

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {

Palette read_palette(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kSize = 256 * 3;
    if (bytes.size() != kSize)
        throw InputError("palette", std::to_string(bytes.size()) + " bytes, expected 256 colours of 3 bytes");
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) palette.colours[i] = {bytes[i * 3], bytes[i * 3 + 1], bytes[i * 3 + 2]};
    return palette;
}

Palette even_colours() {
    const auto level = [](int sixth) { return static_cast<std::uint8_t>(sixth * 51); };
    Palette palette;
    for (int i = 0; i < 216; ++i) item(palette.colours, i) = {level(i / 36), level(i / 6 % 6), level(i % 6)};
    return palette;
}

namespace {

int squared_distance(Rgb8 a, Rgb8 b) {
    const int red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return red * red + green * green + blue * blue;
}

}  // namespace

std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range) {
    int best = range.begin, best_distance = std::numeric_limits<int>::max();
    for (int index = range.begin; index < range.end; ++index) {
        const int distance = squared_distance(item(palette.colours, index), colour);
        if (distance >= best_distance) continue;
        best = index;
        best_distance = distance;
    }
    return static_cast<std::uint8_t>(best);
}

}  // namespace oblong
