#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "engine/platform/sdl/input.h"

namespace oblong {
namespace {

static_assert(static_cast<int>(PadButton::Touchpad) == SDL_CONTROLLER_BUTTON_TOUCHPAD);
static_assert(static_cast<int>(PadAxis::RightTrigger) == SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
static_assert(kFullAxis == SDL_JOYSTICK_AXIS_MAX);

// The labels on buttons, in PadButton's order, and on the triggers; "": the common name.
struct MakersNames {
    std::array<std::string_view, 11> buttons;
    std::string_view left_trigger, right_trigger;
};
constexpr MakersNames kXbox{{"A", "B", "X", "Y", "View", "", "Menu", "LS", "RS", "LB", "RB"}, "LT", "RT"};
constexpr MakersNames kPlayStation{
    {"Cross", "Circle", "Square", "Triangle", "Share", "", "Options", "L3", "R3", "L1", "R1"}, "L2", "R2"};
constexpr MakersNames kNintendo{{"A", "B", "X", "Y", "Minus", "", "Plus", "LS", "RS", "L", "R"}, "ZL", "ZR"};

const MakersNames* names_of(SDL_GameControllerType type) {
    switch (type) {
        case SDL_CONTROLLER_TYPE_XBOX360:
        case SDL_CONTROLLER_TYPE_XBOXONE:
            return &kXbox;
        case SDL_CONTROLLER_TYPE_PS3:
        case SDL_CONTROLLER_TYPE_PS4:
        case SDL_CONTROLLER_TYPE_PS5:
            return &kPlayStation;
        case SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_PRO:
        case SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_JOYCON_PAIR:
            return &kNintendo;
        default:
            return nullptr;
    }
}

std::string_view makers_name(const MakersNames& names, Input input) {
    if (input == pad_axis(PadAxis::LeftTrigger, true)) return names.left_trigger;
    if (input == pad_axis(PadAxis::RightTrigger, true)) return names.right_trigger;
    const bool has_name = input.device == Device::PadButton && input.code < names.buttons.size();
    return has_name ? names.buttons[input.code] : "";
}

}  // namespace

GamePads::GamePads() : is_available_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {
    if (!is_available_) std::fprintf(stderr, "oblong: no gamepads: %s\n", SDL_GetError());
}

GamePads::~GamePads() {
    pads_.clear();
    if (is_available_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

// Without its number, if there is no such pad.
Input GamePads::numbered(Input input, std::int32_t id) const {
    const auto pad = std::find_if(pads_.begin(), pads_.end(), [&](const Pad& p) { return p.id == id; });
    if (pad != pads_.end()) input.code = static_cast<std::uint16_t>(input.code + 256 * pad->number);
    return input;
}

void GamePads::take(const SDL_Event& event, std::vector<InputEvent>& events, std::vector<InputEvent>& of_each) {
    switch (event.type) {
        case SDL_JOYDEVICEADDED:  // also for joysticks that are no gamepads
            return add(event.jdevice.which);
        case SDL_CONTROLLERDEVICEREMOVED:
            of_each.push_back(
                {InputEvent::Kind::ReleasePad, numbered({Device::PadButton, 0}, event.cdevice.which), 0, 0});
            return remove(event.cdevice.which, events);
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            return take_button(event.cbutton, events, of_each);
        case SDL_CONTROLLERAXISMOTION:
            return take_axis(event.caxis, events, of_each);
        default:
            return;
    }
}

void GamePads::add(std::int32_t device_index) {
    if (SDL_IsGameController(device_index) != SDL_TRUE) {
        const char* name = SDL_JoystickNameForIndex(device_index);
        std::fprintf(stderr,
                     "oblong: gamepad '%s': ignored, SDL does not know its buttons, expected a pad of its list\n",
                     name != nullptr ? name : "without a name");
        return;
    }
    SDL_GameController* controller = SDL_GameControllerOpen(device_index);
    if (controller == nullptr) {
        std::fprintf(stderr, "oblong: gamepad: cannot be opened: %s\n", SDL_GetError());
        return;
    }
    const std::int32_t id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller));
    std::int32_t number = 1;  // the least that is free
    const auto has_number = [&](const Pad& pad) { return pad.number == number; };
    while (std::any_of(pads_.begin(), pads_.end(), has_number)) ++number;
    pads_.push_back({id, number, Owned<SDL_GameController>(controller)});
}

void GamePads::remove(std::int32_t id, std::vector<InputEvent>& events) {
    std::erase_if(pads_, [&](const Pad& pad) { return pad.id == id; });
    if (used_ == id) use_pad(kNone, events);
}

void GamePads::take_button(const SDL_ControllerButtonEvent& event, std::vector<InputEvent>& events,
                           std::vector<InputEvent>& of_each) {
    const Input button{Device::PadButton, event.button};
    const auto kind = event.state == SDL_PRESSED ? InputEvent::Kind::Press : InputEvent::Kind::Release;
    of_each.push_back({kind, numbered(button, event.which), 0, 0});
    if (event.state == SDL_PRESSED) use_pad(event.which, events);
    if (event.which == used_) events.push_back({kind, button, 0, 0});
}

void GamePads::take_axis(const SDL_ControllerAxisEvent& event, std::vector<InputEvent>& events,
                         std::vector<InputEvent>& of_each) {
    if (event.axis >= SDL_CONTROLLER_AXIS_MAX) return;
    const std::int32_t value = event.value;
    const auto axis = static_cast<PadAxis>(event.axis);
    const Input ahead = pad_axis(axis, true), back = pad_axis(axis, false);
    of_each.push_back({InputEvent::Kind::Axis, numbered(ahead, event.which), value, 0});
    of_each.push_back({InputEvent::Kind::Axis, numbered(back, event.which), -value, 0});
    const bool is_other = used_ != kNone && event.which != used_;
    if (is_other && std::abs(value) < kFullAxis / 2) return;  // another pad's stick at rest
    use_pad(event.which, events);
    events.push_back({InputEvent::Kind::Axis, ahead, value, 0});
    events.push_back({InputEvent::Kind::Axis, back, -value, 0});
}

void GamePads::use_pad(std::int32_t id, std::vector<InputEvent>& events) {
    if (used_ == id) return;
    events.push_back({InputEvent::Kind::ReleasePad, {}, 0, 0});
    used_ = id;
}

std::string GamePads::local_name_of(Input input) const {
    const auto pad = std::find_if(pads_.begin(), pads_.end(), [&](const Pad& p) { return p.id == used_; });
    if (pad == pads_.end()) return name_of(input);
    const MakersNames* names = names_of(SDL_GameControllerGetType(pad->controller.get()));
    const std::string_view name = names != nullptr ? makers_name(*names, input) : "";
    return name.empty() ? name_of(input) : "Pad " + std::string(name);
}

}  // namespace oblong
