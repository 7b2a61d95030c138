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

/// What a camera's frame shows in truth.
struct FrameTruth {
    std::vector<std::int32_t> faces;  ///< a pixel each; -1: none
    std::vector<bool> is_close_call;
    std::vector<std::int32_t> exact_edges;        ///< the faces of the engine's frame with default settings
    std::vector<reference::ColourPixel> colours;  ///< means over the pixels
    /// Pixels whose colour some setting of a dial of light, or of mip levels, changes. Others say nothing of such
    /// dials: liquids and glowing colours, texels that are nearer than any smaller mip level.
    std::vector<bool> light_changes, mip_changes;
};

/// `frames`: the level's. `samples_per_axis`: rays whose colours are averaged, each way of a pixel.
FrameTruth make_frame_truth(LevelFrames& frames, const Camera& camera, const reference::Palette& palette,
                            int samples_per_axis);

reference::Palette reference_palette(const Palette& palette);

/// A frame that was drawn, and what it should have been.
struct DrawnFrame {
    const MeasuredLevel& level;
    const Camera& camera;
    const FrameTruth& truth;
    const reference::Palette& palette;
    const FrameRecord& record;
    std::span<const std::uint8_t> pixels;
};

/// A value a pixel, negative where there is none.
struct PixelErrors {
    std::vector<float> displacement;  ///< of texels on the screen, pixels
    std::vector<float> texels;        ///< the same, texels of mip level 0
    std::vector<float> wrong;         ///< 1: another face than the truth's, 0: the same; close calls left out
    /// Where mip level 0 is drawn and light changes the pixel: the distance in RGB, 0 to 255 a channel, from the shown
    /// texel's colour times the true light there.
    std::vector<float> light;
    /// Where mip levels change the pixel, and it shows one face: the distance in RGB from the mean colour of that.
    std::vector<float> colour;
    std::vector<float> edges;  ///< 1: another face than with exact edges, 0: the same
    std::int64_t wrong_close_calls = 0;
    std::vector<float> free;  ///< 1: no face covers it, 0: one does
};

PixelErrors measure_frame(const DrawnFrame& frame);

}  // namespace oblong
