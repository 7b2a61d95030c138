#pragma once

#include <array>
#include <cstdint>

#include "engine/screen/screen.h"
#include "engine/surface/palette.h"

namespace oblong {

/// A small picture of the moment of a save, with the colours that it was shown in.
struct Thumbnail {
    static constexpr std::int32_t kWidth_px = 80, kHeight_px = 50;

    std::array<std::uint8_t, static_cast<std::size_t>(kWidth_px) * kHeight_px> pixels{};  ///< indices, row by row
    Palette palette;

    bool operator==(const Thumbnail& other) const {
        return pixels == other.pixels && palette.colours == other.palette.colours;
    }
};

/// A picture of any mode made small: each pixel has the colour nearest to the mean of those that it covers.
Thumbnail make_thumbnail(Framebuffer picture, const Palette& palette);

/// Draws it with its top left corner at a place, in the nearest colours of the palette that the picture is shown in.
/// What lies outside the picture is left out.
void draw_thumbnail(const Thumbnail& thumbnail, PixelPosition at, const Palette& shown_palette, Framebuffer out);

}  // namespace oblong
