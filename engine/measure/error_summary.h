#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace oblong {

/// A summary of errors, none negative: the root mean square, the 99th percentile (the least error that 99 % of them do
/// not exceed) and the largest. All 0 if there are none.
struct ErrorSummary {
    std::int64_t count = 0;
    double rms = 0, p99 = 0, max = 0;
};

ErrorSummary summarize_errors(std::vector<float> errors);

/// How far the texel shown at a pixel is from its exact place. Both are negative if there is nothing to measure: sky,
/// one colour, no face, or a plane that is not in front of the eye there.
struct TexelError {
    /// From the pixel's centre to the place on the screen where the texel belongs, pixels; at most the picture's
    /// diagonal, which also stands for a texel behind the eye.
    float pixels = -1;
    /// From the texel that belongs at the pixel's centre to the one shown, texels of mip level 0.
    float texels = -1;
    bool is_measured() const { return pixels >= 0; }
};

/// Of the pixels that were measured.
ErrorSummary summarize_pixels(std::span<const TexelError> errors);

}  // namespace oblong
