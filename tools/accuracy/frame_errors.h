#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/surface/palette.h"
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

}  // namespace oblong
