#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "engine/level/bsp_read.h"
#include "tests/support/folders.h"
#include "tools/gallery/row.h"

namespace oblong::test {

/// The gallery's assets as they are built, and a canvas with a border around it that nothing may touch.
class GalleryTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const std::filesystem::path assets = std::filesystem::path(test::build_folder()) / "assets";
        level_ = std::make_unique<Level>(read_bsp(read_file_bytes(assets / "demo.bsp")));
        colormap_ = std::make_unique<Colormap>(make_colormap(read_palette(read_file_bytes(assets / "palette.lmp"))));
    }
    static void TearDownTestSuite() {
        level_.reset();
        colormap_.reset();
    }

    static constexpr std::uint8_t kGuard = 0xa5;
    static constexpr std::int32_t kBorder_px = 16;

    struct Drawn {
        Figures figures;
        std::vector<std::uint8_t> pixels;  ///< with the border
        bool is_border_whole = false;
    };
    /// Draws a row with its header and footer.
    static Drawn draw(const Row& row, const std::vector<std::int64_t>& values, const ScreenMode& mode = {},
                      const Settings& settings = {}) {
        const GalleryAssets assets{*level_, *colormap_, text_colours_of(colormap_->palette)};
        const std::int32_t pitch = mode.width_px + 2 * kBorder_px;
        Drawn drawn;
        drawn.pixels.assign(pixel_count(pitch, mode.height_px + 2 * kBorder_px), kGuard);
        const Framebuffer canvas{drawn.pixels.data() + kBorder_px * pitch + kBorder_px, mode.width_px, mode.height_px,
                                 pitch};
        drawn.figures = draw_row(row, {assets, mode, settings, values}, 0, canvas);
        std::vector<std::uint8_t> border = drawn.pixels;
        const Framebuffer inside{border.data() + kBorder_px * pitch + kBorder_px, mode.width_px, mode.height_px, pitch};
        for (std::int32_t y = 0; y < mode.height_px; ++y) std::fill_n(inside.row(y), mode.width_px, kGuard);
        drawn.is_border_whole =
            std::all_of(border.begin(), border.end(), [](std::uint8_t pixel) { return pixel == kGuard; });
        return drawn;
    }

  private:
    static inline std::unique_ptr<Level> level_;
    static inline std::unique_ptr<Colormap> colormap_;
};

}  // namespace oblong::test
