#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/platform/input_events.h"
#include "engine/surface/palette.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

namespace oblong {

/// How a window shows its pictures: what a player may choose.
struct WindowSettings {
    bool is_full_screen = false;
    bool waits_for_display = true;       ///< vsync: as many frames as the display shows, and no torn ones where it can
    std::int32_t frames_per_second = 0;  ///< at most; 0: no limit but the display's

    bool operator==(const WindowSettings&) const = default;
};

/// Input, clock and output of the game: a window (platform/sdl), a web page's canvas
/// (platform/web) or memory (platform/headless).
class Platform {
  public:
    virtual ~Platform() = default;

    virtual bool is_open() const = 0;            ///< false once the user has closed it, or the script has ended
    virtual PlatformInput poll() = 0;            ///< since the last poll
    virtual std::uint64_t now_us() = 0;          ///< a clock that never runs backwards; starts anywhere
    virtual WindowSize window_size() const = 0;  ///< of the drawable, in pixels of the device
    virtual void set_title(const char* title) = 0;
    virtual bool shows_icon() const { return false; }  ///< whether set_icon() does something
    /// The window's icon: four bytes a pixel, red, green, blue and alpha, rows from top to bottom.
    virtual void set_icon(std::span<const std::uint8_t> /*rgba*/, WindowSize /*size*/) {}
    /// Whether the mouse turns the view and can't leave the window, or points at a menu. Where that changes, keys and
    /// buttons are let go of: what was pressed in a menu does nothing in the game.
    virtual void capture_mouse(bool /*is_captured*/) {}
    /// What an input is called on the player's own keyboard and gamepad, in printable ASCII; without any: name_of().
    virtual std::string local_name_of(Input input) const { return name_of(input); }
    /// From the next picture on. Can be called for every frame: what is as it was costs nothing.
    virtual void change_window(const WindowSettings&) {}
    /// Waits for input that poll() would report, or for `timeout_ms`, without using the processor: for a game that is
    /// paused or minimised. False: nothing came, and what was presented last is still shown. Without a window there is
    /// nothing to wait for: it returns at once.
    virtual bool wait_for_input(std::int32_t /*timeout_ms*/) { return true; }

    /// Shows the picture, in `shown` of the window, black around it. Waits for the display where it can.
    virtual void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) = 0;
};

}  // namespace oblong
