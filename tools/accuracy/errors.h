#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/measure/texel_error.h"
#include "engine/reference/colour.h"
#include "engine/surface/palette.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/measured_level.h"

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

/// By measure, a value for each pixel; negative: none. Of shares of pixels it is 1 or 0. Of colours: the distance in
/// RGB, 0 to 255 a channel; LightColour, from the shown texel's colour times the exact light, if mip level 0 is drawn
/// and light changes the pixel; PixelColour, if mip levels change the pixel and it shows one face.
using PixelErrors = std::array<std::vector<float>, kMeasureCount>;

PixelErrors measure_frame(const DrawnFrame& frame);

/// By measure, the errors of one setting: of pixels, or of frames' shares of pixels, per mille.
using ErrorSummaries = std::array<ErrorSummary, kMeasureCount>;

/// The values at the ends of a heat map's colours, and their captions.
struct HeatScale {
    double least = 0, greatest = 0;
    std::string_view least_text, greatest_text;
};

struct MeasureRow {
    std::string_view name;   ///< in the report's file: "displacement", "wrong_pixels"
    std::string_view unit;   ///< "pixels", "wrong pixels per mille of a frame", "RGB distance, 0 to 442"
    std::string_view about;  ///< one sentence on what is measured
    bool is_share = false;   ///< of a frame's pixels
    HeatScale heat{1.0 / 256, 64, "1/256 pixel", "64 pixels"};
};
const MeasureRow& row_of(Measure measure);

/// Collects errors over frames.
class ErrorCollector {
  public:
    void add(const PixelErrors& frame);
    ErrorSummaries summarize() const;

  private:
    std::array<std::vector<float>, kMeasureCount> values_;
};

/// The root of the mean square of the values that are not negative.
double rms_of(const std::vector<float>& values);

/// Dark blue to yellow, on a logarithmic scale; grey: no value.
Palette heat_palette();
/// The palette index of each value.
std::vector<std::uint8_t> heat_pixels(const std::vector<float>& values, Measure measure);

}  // namespace oblong
