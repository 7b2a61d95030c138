#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "engine/files/log_channels.h"
#include "engine/raster/lines.h"
#include "engine/view/present_rect.h"
#include "game/options/player_folders.h"
#include "game/options/preferences_store.h"

namespace oblong {

/// The level that is asked for; empty strings where nothing is.
struct LevelOptions {
    std::string level, palette, models;
    std::string map, game;  ///< a level by its name, and the folder of a game like Quake's
    std::string watch;      ///< the source of a level that is compiled when it changes
};

/// What is done with a game instead of, or besides, playing it; empty strings and 0 where nothing is.
struct RunOptions {
    std::string record, replay, timedemo, route;
    std::int64_t headless_frames = 0;
    std::string out;
    std::int64_t threads = 1;
};

/// What a program is started with: the command line's options, over what is kept in the options file.
struct Options : LevelOptions, RunOptions {
    Preferences preferences;                   ///< as they are kept, changed by the command line
    std::map<std::string, std::string> light;  ///< of the first game, by preferences' names: what the command line says
    WindowSize window;
    LogChannels log;
    MapView automap = MapView::Off;
    Wireframe wireframe = Wireframe::Off;
    LineMethod line_method = LineMethod::GuptaSproull;
    PlayerFolders folders;     ///< of the player's files: empty names where they are neither read nor written
    bool shows_title = false;  ///< also where nothing else is asked for
    bool shows_gallery = false, shows_error_box = false;
};

/// Runs `body` with the options and the file that keeps preferences; the program's exit code: 0 also after --help and
/// --version, 1 for what `body` throws, 2 for wrong usage, both reported on standard error.
int run_with_options(int argument_count, const char* const* arguments,
                     const std::function<void(const Options&, PreferencesStore&)>& body);

}  // namespace oblong
