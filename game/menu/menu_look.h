#pragma once

#include <array>
#include <string_view>

#include "engine/draw/drawing.h"

namespace oblong {

/// The rows of a letter, top to bottom.
inline constexpr int kLetteringRamp = 7;

/// The menu's colours, the nearest of a palette.
struct MenuLook {
    explicit MenuLook(const Palette& palette);

    TextColours text;                                 ///< of the chosen row and of titles
    std::uint8_t plain = 0, dim = 0;                  ///< of other rows; of help and of rows without an action
    std::uint8_t bar = 0, edge = 0;                   ///< behind the chosen row; its borders
    std::array<std::uint8_t, kLetteringRamp> ramp{};  ///< of large letters, top to bottom
    ColourTable veil{};                               ///< darkens the picture behind
};

/// A pixel of large letters, in pixels of the canvas.
struct LetterCell {
    std::int32_t width_px = 6, height_px = 6;
};

/// The size of a line of large letters: six columns of cells for each letter, less one in all; seven rows. Its y is
/// that of the highest accent, 0 or negative.
Area lettering_size(std::string_view line, LetterCell cell);

}  // namespace oblong
