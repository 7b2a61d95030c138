#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/surface/palette.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/measured_level.h"
#include "tools/measure/texel_error.h"
#include "tools/reference/colour.h"

namespace oblong {

/// The exact contents of a camera's frame.
struct FrameTruth {
    std::vector<std::int32_t> faces;  ///< of each pixel; -1: none
    std::vector<bool> is_close_call;
    std::vector<std::int32_t> exact_edges;        ///< the faces of the engine's frame with default settings
    std::vector<reference::ColourPixel> colours;  ///< means over the pixels
    /// Pixels whose colour depends on some setting of a dial of light, or of mip levels. Liquids, glowing colours, and
    /// texels nearer than any smaller mip level do not.
    std::vector<bool> light_changes, mip_changes;
};

/// `frames`: the level's. `samples_per_axis`: the averaged rays along each axis of a pixel.
FrameTruth make_frame_truth(LevelFrames& frames, const Camera& camera, const reference::Palette& palette,
                            int samples_per_axis);

reference::Palette reference_palette(const Palette& palette);

/// A drawn frame and its exact contents.
struct DrawnFrame {
    const MeasuredLevel& level;
    const Camera& camera;
    const FrameTruth& truth;
    const reference::Palette& palette;
    const FrameRecord& record;
    std::span<const std::uint8_t> pixels;
};

/// A value for each pixel; negative: none.
struct PixelErrors {
    std::vector<float> displacement;  ///< of texels on the screen, pixels
    std::vector<float> texels;        ///< the same, texels of mip level 0
    std::vector<float> wrong;         ///< 1: a wrong face, 0: the right one; without close calls
    /// If mip level 0 is drawn and light changes the pixel: the distance in RGB, 0 to 255 a channel, from the shown
    /// texel's colour times the exact light.
    std::vector<float> light;
    /// If mip levels change the pixel, and it shows one face: the distance in RGB from the mean colour of its area.
    std::vector<float> colour;
    std::vector<float> edges;  ///< 1: another face than with exact edges, 0: the same
    std::int64_t wrong_close_calls = 0;
    std::vector<float> free;  ///< 1: no face covers it, 0: one does
};

PixelErrors measure_frame(const DrawnFrame& frame);

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
