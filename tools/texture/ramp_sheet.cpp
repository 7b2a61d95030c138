#include "tools/texture/ramp_sheet.h"

#include "engine/base/table.h"
#include "engine/files/png.h"
#include "engine/surface/colormap.h"

namespace oblong {

std::vector<std::uint8_t> make_ramp_sheet(const Palette& palette) {
    constexpr std::int32_t kWidth_px = Colormap::kShades * kRampCellWidth_px, kHeight_px = 256 * kRampCellHeight_px;
    const Colormap colormap = make_colormap(palette);
    std::vector<std::uint8_t> pixels;
    for (std::int32_t y = 0; y < kHeight_px; ++y)
        for (std::int32_t x = 0; x < kWidth_px; ++x)
            pixels.push_back(at(at(colormap.shades, x / kRampCellWidth_px), y / kRampCellHeight_px));
    return encode_indexed_png(pixels, kWidth_px, kHeight_px, palette);
}

}  // namespace oblong
