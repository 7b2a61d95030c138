#pragma once

#include <memory>
#include <string>

#include "game/gallery.h"
#include "game/options.h"
#include "game/session.h"

namespace oblong {

/// What a game begins with.
ViewOptions view_options_of(const Options& options);

/// The files of the level that the options name. Throws FileError where --map names none.
LevelFiles level_files_of(const Options& options, const std::string& assets_folder);

/// What a program reads before it opens a window.
struct ProgramFiles {
    std::shared_ptr<const LoadedLevel> loaded;
    TickInputSource input;  ///< of the first game in it
};

/// Reads the level and the demo that the options name, and checks that what they record can be written. Throws
/// FileError.
ProgramFiles load_program_files(const Options& options, const std::string& assets_folder);

/// The game from its start until it is left: the one loop of input, the screen that is up, and the window.
class Program {
  public:
    /// `platform` and `workers`, which may be null, outlive the program.
    Program(const Options& options, ProgramFiles files, Platform& platform, Workers* workers);

    /// Until the platform closes or the player leaves. Then writes the demo that was recorded, if any. Throws
    /// FileError.
    void run();

  private:
    void show_frame();

    const Options options_;
    ViewOptions view_options_;
    Platform& platform_;
    SessionSettings settings_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<Gallery> gallery_;
};

}  // namespace oblong
