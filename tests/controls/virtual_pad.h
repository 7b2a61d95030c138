#pragma once

#include <SDL.h>

#include <cstdint>

#include "engine/platform/input.h"

namespace oblong::test {

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
