#pragma once

#include <memory>
#include <string>

#include "engine/platform/platform.h"
#include "game/input/input_mapper.h"
#include "game/options/options.h"
#include "game/program/screens.h"

namespace oblong {

/// The game from start to end: the main loop of input, the current screen and the window.
class Program {
  public:
    /// `store`, which keeps the player's changes, `platform` and the workers outlive the program.
    Program(const Options& options, ProgramFiles files, PreferencesStore& store, Platform& platform,
            ProgramParts parts);

    /// Runs until the platform closes or the player leaves. Then writes the recorded demo, if any. Throws FileError.
    void run();
    /// One iteration of run(), for platforms that call the game instead: takes the input, and shows a picture if it
    /// differs from the last one. False once the game has ended and all is written.
    bool step();
    /// Saves the walk and the options, as at the end: for platforms that may end the program without another step.
    void keep();

  private:
    void show_frame();
    std::int32_t shown_for_ms();
    void take(const Controls& controls);
    void take_in_menu(const Controls& controls);
    void tell_of(const std::string& unsaved);
    void tell_in_menu(const std::string& unsaved);
    void take_on_screen(const Controls& controls);
    void draw();
    void present(const ShownPicture& picture) { platform_.present(picture.canvas, picture.palette, picture.rect); }
    void draw_menu(const ShownPicture& picture);
    bool is_moving() { return !screens_.menu().is_open() || screens_.up().moves_behind_menu(); }
    const Preferences& preferences() { return screens_.view_options().preferences; }

    const std::string replayed_;  // the demo's file; "": none
    PreferencesStore& store_;
    Platform& platform_;
    Screens screens_;
    InputMapper input_;
    bool had_focus_ = false, is_mouse_captured_ = false;
    bool wants_screenshot_ = false;                     // of a menu
    bool has_told_ = false, has_told_in_menu_ = false;  // of options that cannot be saved
    bool is_stale_ = true;                              // the window does not show the current state
    WindowSize shown_size_;
};

/// The platform of --headless: as many pictures as it says, a tick each, written as PNGs into the folder of --out. Its
/// input is a short walk, or the replayed demo. The options outlive it.
std::unique_ptr<Platform> open_headless(const Options& options);

/// Shows an error, as long as it may be, until the user closes the window or presses Enter, Esc or the mouse.
void show_error(const std::string& text, Platform& platform);

/// The same in a window of its own: a player who started the game from a menu does not see standard error. Drawn with
/// the game's own letters, since SDL's message boxes need fonts or programs that some desktops lack. Does nothing
/// without a display.
void show_error_window(const std::string& text);

/// Runs the game as the command line says; returns the exit code. With --error-box, an error is also shown in a window,
/// after it was printed. `open_gallery`: null where another program shows the gallery.
int start_game(int argument_count, const char* const* arguments, OpenGallery open_gallery);

}  // namespace oblong
