#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/base/input_error.h"
#include "engine/frame/frame.h"
#include "engine/scene/placed_models.h"
#include "tests/support/levels.h"
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

    Stage(const std::string& name, const std::filesystem::path& palette, ScreenMode screen_mode = {})
        : level(read_level(name)),
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
    return Stage(name, find_shared_folder() / "levels" / "gfx" / "palette.lmp", mode);
}
inline Stage demo_stage(ScreenMode mode = {}) {
    return Stage("demo", build_folder() + "/assets/palette.lmp", mode);
}
inline Stage stage_named(const std::string& name) {
    return name == "demo" ? demo_stage() : real_stage(name);
}

}  // namespace oblong::test
