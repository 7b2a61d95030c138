#pragma once

#include <cstdint>
#include <map>

#include "engine/platform/dos/calls.h"
#include "engine/platform/dos/vga.h"
#include "engine/platform/platform.h"

namespace oblong::dos {

/// A PC without an operating system: VGA, keyboard, PS/2 mouse, timer.
class Pc : public Platform {
  public:
    bool is_open() const override { return true; }  ///< until the player leaves
    PlatformInput poll() override;
    std::uint64_t now_us() override;
    /// A 4:3 monitor with square pixels: the picture fills it.
    WindowSize window_size() const override { return {1600, 1200}; }
    void set_title(const char*) override {}
    void capture_mouse(bool is_captured) override;
    void change_window(const WindowSettings& settings) override { settings_ = settings; }
    bool wait_for_input(std::int32_t timeout_ms) override;
    void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) override;

  private:
    void take_keys();
    void take_key(std::uint16_t usage, bool is_released);
    void take_mouse();
    void note(InputEvent::Kind kind, Input input) { input_.events.push_back({kind, input, 0, 0}); }

    Vga vga_;
    WindowSettings settings_;
    PlatformInput input_;
    bool is_extended_ = false;            // the last byte was E0h
    std::map<std::uint16_t, bool> held_;  // keys, by usage
    bool is_captured_ = false;
    std::uint32_t buttons_ = 0;
    Pointer pointer_{800, 600, false, false};
    std::uint64_t shown_us_ = 0;
};

}  // namespace oblong::dos
