#pragma once

#include <cstdint>
#include <memory>

#include "engine/effects/colour_tables.h"
#include "engine/raster/lines.h"
#include "engine/surface/nearest_colour.h"
#include "engine/surface/palette.h"

namespace oblong {

/// Whether the map is shown, and what is up on it.
enum class MapView : std::uint8_t { Off, PlayerUp, NorthUp };
inline constexpr int kMapViewCount = 3;

/// Whether the edges of visible faces are drawn: over the picture, or by themselves.
enum class Wireframe : std::uint8_t { Off, Over, Alone };
inline constexpr int kWireframeCount = 3;

/// A colour of lines over the picture, with the table that blends their borders.
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
