#include "engine/platform/crt_mask.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/trig.h"

namespace oblong {
namespace {

constexpr std::int64_t kDarkest_256 = 140;   // the loss of light at the edges of rows
constexpr std::uint32_t kThrough_256 = 205;  // the factor of a column for the other two channels

// The share of light in a row of pixels: least at the edges of the picture's rows.
std::uint32_t row_light_256(std::int64_t y, std::int64_t height_px, std::int64_t rows) {
    const std::int64_t pixels_256 = height_px * 256 / rows;
    const std::int64_t depth_256 = std::clamp<std::int64_t>(pixels_256 - 512, 0, 256) * kDarkest_256 / 256;
    const Angle phase = Angle::from_bam((2 * y + 1) * rows % (2 * height_px) * 65'536 / (2 * height_px));
    const std::int64_t border_30 = (std::int64_t{floor_of<30>(cosine(phase))} + (1 << 30)) / 2;
    return static_cast<std::uint32_t>(256 - (depth_256 * border_30 >> Unit::kFractionBits));
}

std::uint32_t argb(std::uint32_t row_light_256, std::int32_t x) {
    std::uint32_t pixel = 0xff;
    for (std::int32_t channel = 0; channel < 3; ++channel) {
        const std::uint32_t through_256 = x % 3 == channel ? 256 : kThrough_256;
        pixel = pixel << 8 | std::min<std::uint32_t>(255, row_light_256 * through_256 >> 8);
    }
    return pixel;
}

}  // namespace

std::vector<std::uint32_t> make_crt_mask(std::int32_t width_px, std::int32_t height_px, std::int32_t rows) {
    std::vector<std::uint32_t> mask;
    mask.reserve(as_size(width_px) * as_size(height_px));
    for (std::int32_t y = 0; y < height_px; ++y) {
        const std::uint32_t light_256 = row_light_256(y, height_px, rows);
        const std::array<std::uint32_t, 3> columns{argb(light_256, 0), argb(light_256, 1), argb(light_256, 2)};
        for (std::int32_t x = 0; x < width_px; ++x) mask.push_back(item(columns, x % 3));
    }
    return mask;
}

}  // namespace oblong
