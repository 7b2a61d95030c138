#include "engine/platform/sdl/input.h"

#include <SDL.h>

#include <array>
#include <span>
#include <utility>

namespace oblong {
namespace {

using CommandKey = std::pair<SDL_Scancode, Command>;

constexpr std::array<CommandKey, 24> kCommandKeys{{
    {SDL_SCANCODE_F1, Command::ShowHelp},
    {SDL_SCANCODE_F2, Command::ProjectionAspect},
    {SDL_SCANCODE_F3, Command::DisplayAspect},
    {SDL_SCANCODE_F4, Command::AccuracyTier},
    {SDL_SCANCODE_F5, Command::ScalingMode},
    {SDL_SCANCODE_F6, Command::FrameCost},
    {SDL_SCANCODE_F7, Command::LabPanel},
    {SDL_SCANCODE_F8, Command::ErrorMap},
    {SDL_SCANCODE_F9, Command::SplitView},
    {SDL_SCANCODE_F10, Command::FlipSettings},
    {SDL_SCANCODE_F11, Command::AspectGuide},
    {SDL_SCANCODE_F12, Command::Screenshot},
    {SDL_SCANCODE_4, Command::FourAspects},
    {SDL_SCANCODE_L, Command::Torch},
    {SDL_SCANCODE_C, Command::CrtLook},
    {SDL_SCANCODE_TAB, Command::Automap},
    {SDL_SCANCODE_E, Command::Wireframe},
    {SDL_SCANCODE_MINUS, Command::Darker},
    {SDL_SCANCODE_O, Command::Log},
    {SDL_SCANCODE_P, Command::Inspect},
    {SDL_SCANCODE_I, Command::Isometric},
    {SDL_SCANCODE_LEFTBRACKET, Command::ZoomIn},
    {SDL_SCANCODE_RIGHTBRACKET, Command::ZoomOut},
    {SDL_SCANCODE_EQUALS, Command::Brighter},
}};
constexpr std::array<CommandKey, 6> kRepeatingKeys{{
    {SDL_SCANCODE_UP, Command::DialUp},
    {SDL_SCANCODE_DOWN, Command::DialDown},
    {SDL_SCANCODE_LEFT, Command::DialCoarser},
    {SDL_SCANCODE_RIGHT, Command::DialFiner},
    {SDL_SCANCODE_PAGEUP, Command::PageUp},
    {SDL_SCANCODE_PAGEDOWN, Command::PageDown},
}};

void add_commands(std::span<const CommandKey> keys, SDL_Scancode code, Controls& controls) {
    for (const auto& [key, command] : keys)
        if (code == key) controls.commands.push_back(command);
}

bool is_mouse_captured() {
    return SDL_GetRelativeMouseMode() == SDL_TRUE;
}

// Scancodes, not letters: WASD are four places on the keyboard, in every country.
void read_held_keys(Controls& controls) {
    const std::uint8_t* held = SDL_GetKeyboardState(nullptr);
    controls.forward = held[SDL_SCANCODE_W];
    controls.back = held[SDL_SCANCODE_S];
    controls.left = held[SDL_SCANCODE_A];
    controls.right = held[SDL_SCANCODE_D];
    controls.arrows = {held[SDL_SCANCODE_UP] != 0, held[SDL_SCANCODE_DOWN] != 0, held[SDL_SCANCODE_LEFT] != 0,
                       held[SDL_SCANCODE_RIGHT] != 0};
    controls.look_up = held[SDL_SCANCODE_PAGEUP];
    controls.look_down = held[SDL_SCANCODE_PAGEDOWN];
    controls.walk_slowly = held[SDL_SCANCODE_LSHIFT] || held[SDL_SCANCODE_RSHIFT];
    controls.jump |= held[SDL_SCANCODE_SPACE] != 0;
}

}  // namespace

Controls SdlInput::poll() {
    Controls controls;
    for (SDL_Event event; SDL_PollEvent(&event);) take(event, controls);
    read_held_keys(controls);
    controls.holds_button = is_mouse_captured() && SDL_GetMouseState(nullptr, nullptr) != 0;
    return controls;
}

void SdlInput::capture_mouse(bool is_captured) {
    SDL_SetRelativeMouseMode(is_captured ? SDL_TRUE : SDL_FALSE);
}

bool SdlInput::take_textures_lost() {
    return std::exchange(are_textures_lost_, false);
}

void SdlInput::take(const SDL_Event& event, Controls& controls) {
    switch (event.type) {
        case SDL_QUIT:
            is_closed_ = true;
            break;
        case SDL_KEYDOWN:
            add_commands(kRepeatingKeys, event.key.keysym.scancode, controls);
            if (event.key.repeat == 0) take_key(event.key, controls);
            break;
        case SDL_MOUSEBUTTONDOWN:
            capture_mouse(true);
            break;
        case SDL_MOUSEMOTION:
            if (!is_mouse_captured()) break;
            controls.mouse_x += event.motion.xrel;
            controls.mouse_y += event.motion.yrel;
            break;
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) capture_mouse(false);
            break;
        case SDL_RENDER_TARGETS_RESET:
        case SDL_RENDER_DEVICE_RESET:
            are_textures_lost_ = true;
            break;
        default:
            break;
    }
}

void SdlInput::take_key(const SDL_KeyboardEvent& key, Controls& controls) {
    const SDL_Scancode code = key.keysym.scancode;
    if (code == SDL_SCANCODE_ESCAPE) return leave();
    if (code == SDL_SCANCODE_RETURN && (key.keysym.mod & KMOD_ALT) != 0) return toggle_fullscreen();
    if (code == SDL_SCANCODE_SPACE) controls.jump = true;  // also when let go before the poll
    add_commands(kCommandKeys, code, controls);
}

void SdlInput::toggle_fullscreen() {
    const bool is_full = (SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    SDL_SetWindowFullscreen(window_, is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

void SdlInput::leave() {
    if (is_mouse_captured())
        capture_mouse(false);
    else
        is_closed_ = true;
}

}  // namespace oblong
