#include "engine/methods/dac6.h"

namespace oblong {

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
