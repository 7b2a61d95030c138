#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "engine/programs/frame_log.h"
#include "engine/raster/lines.h"
#include "engine/view/present_rect.h"
#include "game/options/preferences_store.h"

namespace oblong {

/// Where a player's files are kept; empty if the system names no folder for them.
struct PlayerFolders {
    std::string config_file;  ///< preferences
    std::string data;         ///< the folder of saved games
    std::string fault = {};   ///< why a played game keeps less than it would; empty: it keeps all
};

/// A program's start options: the options file's values, overridden by the command line. Empty strings and 0: not
/// given.
struct Options {
    std::string level, palette, models;  ///< files of the level to play
    std::string map, game;               ///< a level's name, and the folder of a game like Quake's
    std::string watch;                   ///< the source of a level that is compiled when it changes
    std::string room;                    ///< where to begin, with what Visit opens
    std::string record, replay, timedemo, route;
    std::int64_t headless_frames = 0;
    std::string out;
    std::int64_t threads = 1;
    Preferences preferences;                   ///< from the options file, changed by the command line
    std::map<std::string, std::string> light;  ///< of the first game, from the command line, by preference name
    WindowSize window;
    LogChannels log;
    MapView automap = MapView::Off;
    Wireframe wireframe = Wireframe::Off;
    LineMethod line_method = LineMethod::GuptaSproull;
    PlayerFolders folders;     ///< of the player's files; empty names: neither read nor written
    bool shows_title = false;  ///< also if no level or other run is given
    bool shows_gallery = false, shows_error_box = false;
    bool chooses_view = false;  ///< view-size, double-columns and accuracy by the times of the first pictures
};

/// Runs `body` with the options and the store of preferences. Returns the program's exit code: 0, also after --help and
/// --version, 1 for what `body` throws, 2 for wrong usage, both reported on standard error.
int run_with_options(int argument_count, const char* const* arguments,
                     const std::function<void(const Options&, PreferencesStore&)>& body);

}  // namespace oblong
