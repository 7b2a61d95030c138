#pragma once

#include <SDL.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "engine/platform/input.h"
#include "engine/platform/sdl/input.h"

namespace oblong::test {

/// SDL with a window of a driver that shows nothing, so that it has no focus: gamepads are heard all the same.
class UnseenWindow {
  public:
    UnseenWindow() {
        SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        EXPECT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
        window_ = SDL_CreateWindow("test", 0, 0, 640, 480, 0);
        EXPECT_NE(window_, nullptr) << SDL_GetError();
        input = std::make_unique<SdlInput>(window_);
    }
    ~UnseenWindow() {
        input.reset();
        SDL_DestroyWindow(window_);
        SDL_Quit();
    }
    UnseenWindow(const UnseenWindow&) = delete;
    UnseenWindow& operator=(const UnseenWindow&) = delete;

    std::unique_ptr<SdlInput> input;

  private:
    SDL_Window* window_ = nullptr;
};

/// A gamepad that SDL takes for one that is plugged in, until it goes out of scope. SDL's joysticks must be up.
class VirtualPad {
  public:
    explicit VirtualPad(SDL_JoystickType type = SDL_JOYSTICK_TYPE_GAMECONTROLLER)
        : index_(SDL_JoystickAttachVirtual(type, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0)),
          id_(SDL_JoystickGetDeviceInstanceID(index_)),
          joystick_(SDL_JoystickOpen(index_)) {
        set(PadAxis::LeftTrigger, INT16_MIN);  // at rest
        set(PadAxis::RightTrigger, INT16_MIN);
    }
    ~VirtualPad() { unplug(); }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    bool is_plugged_in() const { return joystick_ != nullptr; }
    void press(PadButton button) { SDL_JoystickSetVirtualButton(joystick_, static_cast<int>(button), SDL_PRESSED); }
    void release(PadButton button) { SDL_JoystickSetVirtualButton(joystick_, static_cast<int>(button), SDL_RELEASED); }
    /// Of a stick: right and down positive. Of a trigger: INT16_MIN is at rest.
    void set(PadAxis axis, std::int32_t value) {
        SDL_JoystickSetVirtualAxis(joystick_, static_cast<int>(axis), static_cast<std::int16_t>(value));
    }
    void unplug() {
        if (joystick_ == nullptr) return;
        SDL_JoystickClose(joystick_);
        joystick_ = nullptr;
        for (int index = 0; index < SDL_NumJoysticks(); ++index)
            if (SDL_JoystickGetDeviceInstanceID(index) == id_) SDL_JoystickDetachVirtual(index);
    }

  private:
    int index_;
    SDL_JoystickID id_;
    SDL_Joystick* joystick_;
};

}  // namespace oblong::test
