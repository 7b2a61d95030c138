#pragma once

#include <cstdint>
#include <string>

#include "engine/camera/camera.h"
#include "engine/frame/settings.h"
#include "engine/screen/present_rect.h"
#include "engine/screen/screen_mode.h"

namespace oblong {

/// What the command line asks for; empty strings and 0 where it says nothing.
struct Options {
    std::string level, palette;
    ScreenMode mode;
    WindowSize window;
    Degrees field_of_view = Degrees::from_int(90);
    Tier tier = Tier::Bounded;
    Scaling scaling = Scaling::Sharp;
    std::string record, replay, timedemo;
    std::int64_t headless_frames = 0;
    std::string out;
};

/// The options of a command line, or the code that the program ends with at once: 0 after --help or --version, 2 for
/// wrong usage, said on standard error.
struct ParsedOptions {
    Options options;
    bool ends = false;
    int exit_code = 0;
};
ParsedOptions parse_options(int argument_count, const char* const* arguments);

}  // namespace oblong
