#pragma once

#include <array>
#include <span>

#include "engine/draw/drawing.h"
#include "engine/draw/text.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"
#include "game/view/sign_colours.h"
#include "tools/measure/texel_error.h"

namespace oblong {

/// The map of the error: each pixel's colour shows how far its texel is from its exact place.
class ErrorMap {
  public:
    /// Errors below the first are dark grey; from each of these on, in 1/256 pixel, another colour begins.
    static constexpr std::array kSteps_256{32, 64, 128, 256, 512, 1024};  // 1/8 to 4 pixels
    static constexpr std::size_t kBands = kSteps_256.size() + 1;
    static_assert(kBands == kErrorBands);

    ErrorMap(const Palette& palette, ColourScheme scheme);

    /// Colours each pixel of a picture by its error, and keeps its brightness visible. `errors`: one for each pixel.
    void draw(std::span<const TexelError> errors, Framebuffer canvas) const;
    /// Draws the legend, with the smallest error of each colour, above the row `bottom`. Returns its top row.
    std::int32_t draw_legend(std::int32_t bottom, TextColours colours, Framebuffer canvas) const;

    /// The band of an error in pixels: 0 below the first step, and without a measurement.
    static std::size_t band_of(float pixels);

  private:
    std::array<ColourTable, kBands> tints_{};  // by band and the colour of the picture
    std::array<std::uint8_t, kBands> swatches_{};
};

}  // namespace oblong
