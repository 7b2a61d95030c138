#pragma once

#include <cstdint>
#include <memory>

#include "engine/effects/colour_tables.h"
#include "engine/raster/lines.h"
#include "engine/surface/palette.h"

namespace oblong {

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
