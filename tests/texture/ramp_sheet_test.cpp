#include "tools/texture/ramp_sheet.h"

#include <gtest/gtest.h>

#include "engine/files/png.h"
#include "engine/surface/colormap.h"
#include "tests/texture/test_palette.h"

namespace oblong {
namespace {

TEST(RampSheet, EachCellIsOneShadeOfOneColour) {
    const Palette palette = test::scattered_palette();
    const Colormap colormap = make_colormap(palette);
    const PngImage sheet = decode_png(make_ramp_sheet(palette));
    ASSERT_EQ(sheet.width_px, 64 * 8);
    ASSERT_EQ(sheet.height_px, 256 * 4);
    for (std::size_t y = 0; y < 256 * 4; ++y)
        for (std::size_t x = 0; x < 64 * 8; ++x)
            ASSERT_EQ(sheet.indices[y * 512 + x], colormap.shades[x / 8][y / 4]) << x << ", " << y;
}

}  // namespace
}  // namespace oblong
