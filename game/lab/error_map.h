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

/// The map of the error: each pixel's colour says how far its texel is off its place.
class ErrorMap {
  public:
    /// Errors below the first are dark grey; from each of these on, 1/256 pixel, they have a colour of their own.
    static constexpr std::array kSteps_256{32, 64, 128, 256, 512, 1024};  // 1/8 to 4 pixels
    static constexpr std::size_t kBands = kSteps_256.size() + 1;
    static_assert(kBands == kErrorBands);

    ErrorMap(const Palette& palette, ColourScheme scheme);

    /// Colours each pixel of a picture, which stays recognisable by its brightness. `errors`: one a pixel.
    void draw(std::span<const TexelError> errors, Framebuffer canvas) const;
    /// Draws what the colours mean, pixels from which on each is used, above the row `bottom`. The row above which it
    /// ends.
    std::int32_t draw_legend(std::int32_t bottom, TextColours colours, Framebuffer canvas) const;

    /// The band of an error, pixels: 0 below the first step, and where nothing is measured.
    static std::size_t band_of(float pixels);

  private:
    std::array<ColourTable, kBands> tints_{};  // by band and the colour of the picture
    std::array<std::uint8_t, kBands> swatches_{};
};

}  // namespace oblong
