#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/surface/palette.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/frame_errors.h"

namespace oblong {

/// The errors of one setting over some frames.
struct ErrorSummaries {
    ErrorSummary displacement;  ///< pixels
    ErrorSummary texels;        ///< texels
    ErrorSummary wrong;         ///< of frames: pixels with a wrong face, per mille of those that are not close calls
    ErrorSummary edges;         ///< of frames: pixels of another face than with exact edges, per mille
    ErrorSummary close_calls;   ///< of frames: close calls with a wrong face, per mille of all pixels
    ErrorSummary free_pixels;   ///< of frames: pixels that no face covers, per mille
    ErrorSummary light;         ///< RGB
    ErrorSummary colour;        ///< RGB
};

const ErrorSummary& summary_of(const ErrorSummaries& errors, Measure measure);
/// "pixels", "wrong pixels per mille of a frame", "RGB distance (0 to 442)".
std::string_view unit_of(Measure measure);
/// One sentence on what is measured.
std::string_view about(Measure measure);

/// Collects errors over frames.
class ErrorCollector {
  public:
    void add(const PixelErrors& frame);
    ErrorSummaries summarize() const;

  private:
    std::vector<float> displacement_, texels_, wrong_, edges_, close_calls_, free_, light_, colour_;
};

/// The value of each pixel by a measure.
const std::vector<float>& pixels_by(const PixelErrors& errors, Measure measure);
/// The root of the mean square of the values that are not negative.
double rms_of(const std::vector<float>& values);

/// The values at the ends of a heat map's colours, and their captions.
struct HeatScale {
    double least = 0, greatest = 0;
    std::string least_text, greatest_text;
};
HeatScale heat_scale(Measure measure);

/// Dark blue to yellow, on a logarithmic scale; grey: no value.
Palette heat_palette();
/// The palette index of each value.
std::vector<std::uint8_t> heat_pixels(const std::vector<float>& values, Measure measure);

}  // namespace oblong
