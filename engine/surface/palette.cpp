#include "engine/surface/palette.h"

#include <string>

#include "engine/base/input_error.h"

namespace oblong {

Palette read_palette(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kSize = 256 * 3;
    if (bytes.size() != kSize)
        throw InputError("palette", std::to_string(bytes.size()) + " bytes, expected 256 colours of 3 bytes");
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) palette.colours[i] = {bytes[i * 3], bytes[i * 3 + 1], bytes[i * 3 + 2]};
    return palette;
}

Palette as_shown_by_dac6(const Palette& palette) {
    const auto through_dac = [](std::uint8_t channel) { return widen_dac6(narrow_dac6(channel)); };
    Palette shown;
    for (std::size_t i = 0; i < 256; ++i) {
        const Rgb8 colour = palette.colours[i];
        shown.colours[i] = {through_dac(colour.red), through_dac(colour.green), through_dac(colour.blue)};
    }
    return shown;
}

}  // namespace oblong
