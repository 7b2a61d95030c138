#include "engine/platform/sdl/input.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace oblong {
namespace {

bool is_mouse_captured() {
    return SDL_GetRelativeMouseMode() == SDL_TRUE;
}

// Scancodes, not letters: WASD are the same four places on every keyboard layout.
Input key_of(SDL_Scancode code) {
    return {Device::Key, static_cast<std::uint16_t>(code)};
}

// From SDL's numbers, in which the middle button is 2.
Input mouse_button_of(std::uint8_t button) {
    constexpr std::array<std::uint16_t, 4> kNumbers{0, 1, 3, 2};
    return mouse_button(button < kNumbers.size() ? kNumbers[button] : button);
}

Input wheel_of(WheelTurn turn) {
    return {Device::MouseWheel, static_cast<std::uint16_t>(turn)};
}

// The window of an event; null if it is of none.
SDL_Window* window_of(const SDL_Event& event) {
    switch (event.type) {
        case SDL_WINDOWEVENT:
        case SDL_KEYDOWN:
        case SDL_KEYUP:
        case SDL_TEXTINPUT:
        case SDL_MOUSEMOTION:
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
        case SDL_MOUSEWHEEL:
            return SDL_GetWindowFromID(event.window.windowID);  // which all of these have in the same place
        case SDL_CONTROLLERAXISMOTION:
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            return SDL_GetKeyboardFocus();
        default:
            return nullptr;
    }
}

}  // namespace

// Asks for counts of the device, without the system's acceleration and scale.
SdlInput::SdlInput(SDL_Window* window) : window_(window) {
    SDL_SetHint(SDL_HINT_MOUSE_RELATIVE_SYSTEM_SCALE, "0");
    SDL_SetHint(SDL_HINT_MOUSE_RELATIVE_MODE_WARP, "0");
    SDL_SetHint(SDL_HINT_MOUSE_RELATIVE_SCALING, "0");
}

// Events of another window of the program stay for its own poll, as far as there is room; those of the pads go to the
// window with the focus.
PlatformInput SdlInput::poll() {
    constexpr std::size_t kMostKept = 1000;
    std::vector<SDL_Event> kept;
    for (SDL_Event event; SDL_PollEvent(&event);) {
        if (SDL_Window* const window = window_of(event); window == nullptr || window == window_)
            take(event);
        else if (kept.size() < kMostKept)
            kept.push_back(event);
    }
    for (SDL_Event& event : kept) SDL_PushEvent(&event);
    PlatformInput input;
    input.events = std::exchange(events_, {});
    input.pad_events = std::exchange(pad_events_, {});
    input.text = std::exchange(text_, {});
    const std::uint32_t flags = SDL_GetWindowFlags(window_);
    input.has_focus = (flags & SDL_WINDOW_INPUT_FOCUS) != 0;
    input.is_minimised = (flags & SDL_WINDOW_MINIMIZED) != 0;
    input.changes_full_screen = std::exchange(changes_full_screen_, false);
    input.pointer = pointer_;
    if (pointer_) pointer_->has_moved = pointer_->is_pressed = false;
    return input;
}

// The letter on the user's keyboard: the key W is Z on a French one.
std::string SdlInput::local_name_of(Input input) const {
    if (input.device != Device::Key || input.code < SDL_SCANCODE_A || input.code > SDL_SCANCODE_SLASH)
        return pads_.local_name_of(input);
    const std::string name = name_of_letter(SDL_GetKeyFromScancode(static_cast<SDL_Scancode>(input.code)));
    return name.empty() ? name_of(input) : name;
}

// Mouse motion before the capture does not turn the view.
void SdlInput::capture_mouse(bool is_captured) {
    if (is_captured == is_mouse_captured()) return;
    SDL_SetRelativeMouseMode(is_captured ? SDL_TRUE : SDL_FALSE);
    SDL_FlushEvent(SDL_MOUSEMOTION);
    SDL_GetRelativeMouseState(nullptr, nullptr);
    note(InputEvent::Kind::ReleasePressed);
    pointer_.reset();
}

void SdlInput::take(const SDL_Event& event) {
    switch (event.type) {
        case SDL_QUIT:
            is_closed_ = true;
            break;
        case SDL_KEYDOWN:
        case SDL_KEYUP:
            take_key(event.key);
            break;
        case SDL_TEXTINPUT:
            text_ += static_cast<const char*>(event.text.text);
            break;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            take_button(event.button);
            break;
        case SDL_MOUSEWHEEL:
            take_wheel(event.wheel);
            break;
        case SDL_MOUSEMOTION:
            take_motion(event.motion);
            break;
        case SDL_WINDOWEVENT:
            take_window_event(event.window.event);
            break;
        case SDL_RENDER_TARGETS_RESET:
        case SDL_RENDER_DEVICE_RESET:
            are_textures_lost_ = true;
            break;
        default:
            pads_.take(event, events_, pad_events_);
            break;
    }
}

void SdlInput::take_key(const SDL_KeyboardEvent& key) {
    const SDL_Scancode code = key.keysym.scancode;
    const bool has_alt = (key.keysym.mod & KMOD_ALT) != 0;
    if (key.state == SDL_RELEASED) return note(InputEvent::Kind::Release, key_of(code));
    if (code == SDL_SCANCODE_BACKSPACE) text_ += '\b';
    if (!has_alt && (code == SDL_SCANCODE_RETURN || code == SDL_SCANCODE_KP_ENTER)) text_ += '\n';
    if (key.repeat != 0) return note(InputEvent::Kind::Repeat, key_of(code));
    if (has_alt && code == SDL_SCANCODE_RETURN) {
        changes_full_screen_ = !changes_full_screen_;
        return;
    }
    if (has_alt && code == SDL_SCANCODE_TAB) return;  // to another window
    note(InputEvent::Kind::Press, key_of(code));
}

void SdlInput::take_button(const SDL_MouseButtonEvent& button) {
    const Input input = mouse_button_of(button.button);
    if (button.state == SDL_RELEASED) return note(InputEvent::Kind::Release, input);
    if (is_mouse_captured()) return note(InputEvent::Kind::Press, input);
    point_at(button.x, button.y);
    pointer_->is_pressed |= button.button == SDL_BUTTON_LEFT;
    note(InputEvent::Kind::Click, input);
}

// A mouse that rests where the window opens, or enters it, has not moved, so it chooses nothing.
void SdlInput::take_motion(const SDL_MouseMotionEvent& motion) {
    if (is_mouse_captured()) {
        events_.push_back({InputEvent::Kind::MouseMotion, {}, motion.xrel, motion.yrel});
        return;
    }
    const std::optional<Pointer> before = pointer_;
    point_at(motion.x, motion.y);
    pointer_->has_moved |= before && (before->x_px != pointer_->x_px || before->y_px != pointer_->y_px);
}

// Converts the window's units to pixels: they differ on high-density displays.
void SdlInput::point_at(std::int32_t x, std::int32_t y) {
    int width = 0, height = 0, width_px = 0, height_px = 0;
    SDL_GetWindowSize(window_, &width, &height);
    SDL_GetWindowSizeInPixels(window_, &width_px, &height_px);
    const auto scaled = [](std::int32_t at, int size_px, int size) {
        return static_cast<std::int32_t>(std::int64_t{at} * size_px / std::max(size, 1));
    };
    if (!pointer_) pointer_.emplace();
    pointer_->x_px = scaled(x, width_px, width);
    pointer_->y_px = scaled(y, height_px, height);
}

void SdlInput::take_wheel(const SDL_MouseWheelEvent& wheel) {
    const auto turn = [&](std::int32_t notches, WheelTurn ahead, WheelTurn back) {
        constexpr std::int32_t kMost = 16;  // more notches than a wheel turns between two polls
        notches = std::clamp(notches, -kMost, kMost);
        for (std::int32_t i = 0; i < std::abs(notches); ++i) {
            note(InputEvent::Kind::Press, wheel_of(notches > 0 ? ahead : back));
            note(InputEvent::Kind::Release, wheel_of(notches > 0 ? ahead : back));
        }
    };
    turn(wheel.y, WheelTurn::Up, WheelTurn::Down);
    turn(wheel.x, WheelTurn::Right, WheelTurn::Left);
}

void SdlInput::take_window_event(std::uint8_t event) {
    if (event == SDL_WINDOWEVENT_CLOSE) is_closed_ = true;
    if (event == SDL_WINDOWEVENT_LEAVE) pointer_.reset();
    if (event != SDL_WINDOWEVENT_FOCUS_LOST) return;
    note(InputEvent::Kind::ReleaseAll);
    capture_mouse(false);
}

}  // namespace oblong
