#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "engine/accuracy/presets.h"
#include "engine/geometry/projection.h"
#include "engine/platform/present_rect.h"
#include "engine/scene/light_styles.h"
#include "engine/screen/screen.h"
#include "game/line_overlays.h"
#include "tools/common/log_channels.h"

namespace oblong {

/// The command line's options; empty strings and 0 where they are not given.
struct Options {
    std::string level, palette, models;
    std::string map, game;  ///< a level by its name, and the folder of a game like Quake's
    ScreenMode mode;
    WindowSize window;
    Degrees field_of_view = Degrees::from_int(90);
    std::int32_t brightness_100 = 100, gamma_100 = 100;
    Flashes flashes = Flashes::Full;
    Preset preset = Preset::Bounded;
    Accuracy accuracy;  ///< the preset with dials turned
    Scaling scaling = Scaling::SharpBilinear;
    bool corrects_projection = true, has_crt_look = false;
    ShownAs shown_as = ShownAs::OnDisplay;
    LogChannels log;
    MapView automap = MapView::Off;
    Wireframe wireframe = Wireframe::Off;
    LineMethod line_method = LineMethod::GuptaSproull;
    std::string record, replay, timedemo, route;
    std::int64_t headless_frames = 0, threads = 1;
    std::string out;
    bool shows_gallery = false, shows_error_box = false;
};

/// Runs `body` with the command line's options; the program's exit code: 0 also after --help and --version, 1 for
/// what `body` throws, 2 for wrong usage, both reported on standard error.
int run_with_options(int argument_count, const char* const* arguments, const std::function<void(const Options&)>& body);

}  // namespace oblong
