#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/accuracy/presets.h"
#include "engine/base/input_error.h"
#include "engine/frame/frame.h"
#include "engine/level/bsp_read.h"
#include "engine/scene/placed_models.h"
#include "tests/support/folders.h"
#include "tests/support/observed_workspace.h"

namespace oblong::test {

/// A level with all that it takes to draw it.
struct Stage {
    Level level;
    Colormap colormap;
    std::vector<PlacedModel> models = models_at_rest(level);
    ScreenMode mode;
    Settings settings;
    std::vector<std::uint8_t> pixels;

    Stage(const std::filesystem::path& bsp, const std::filesystem::path& palette, ScreenMode screen_mode = {})
        : level(read_bsp(read_file_bytes(bsp))),
          colormap(make_colormap(read_palette(read_file_bytes(palette)))),
          mode(screen_mode),
          pixels(static_cast<std::size_t>(mode.width_px * mode.height_px)) {}

    Scene scene() const { return {level, colormap, models}; }

    void draw(const Camera& camera, FrameWorkspace& work) {
        draw_frame(scene(), camera, mode, settings, work,
                   {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    }
};

inline Stage real_stage(const std::string& name, ScreenMode mode = {}) {
    const std::filesystem::path levels = find_shared_folder() / "levels";
    return Stage(levels / (name + ".bsp"), levels / "gfx" / "palette.lmp", mode);
}

inline Stage demo_stage(ScreenMode mode = {}) {
    const std::filesystem::path assets = std::filesystem::path(test::build_folder()) / "assets";
    return Stage(assets / "demo.bsp", assets / "palette.lmp", mode);
}

}  // namespace oblong::test
