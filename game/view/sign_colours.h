#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/effects/colour_tables.h"
#include "engine/raster/lines.h"
#include "engine/surface/palette.h"
#include "game/options/preferences.h"

namespace oblong {

inline constexpr std::size_t kErrorBands = 7;

/// The colours of signs over the picture. No sign depends on its colour alone: steps are broken lines, doors have
/// crosses, the player is an arrow, and the bands of the error have a legend.
struct SignColours {
    Rgb8 wall, step, door, hidden, player, lens;  ///< of the map
    Rgb8 edges;                                   ///< of faces
    std::array<Rgb8, kErrorBands> errors;         ///< of the map of the error, from the smallest
};

const SignColours& sign_colours_of(ColourScheme scheme);

/// A colour of lines over the picture, with the table for blending their edges.
class LineColour {
  public:
    LineColour(const Palette& palette, Rgb8 wanted)
        : colour_(nearest_colour(palette, wanted)),
          blends_(std::make_unique<FogTable>(make_fog_table(palette, palette.colours[colour_]))) {}

    LineStyle style(LineMethod method) const { return {method, colour_, &blends_->levels}; }

  private:
    std::uint8_t colour_;
    std::unique_ptr<FogTable> blends_;
};

}  // namespace oblong
