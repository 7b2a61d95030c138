#include "game/input/input_mapper.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace oblong {
namespace {

constexpr std::int32_t kPressed = kFullAxis / 2, kReleased = kFullAxis * 3 / 8;
constexpr std::uint64_t kFirstRepeat_ms = 400, kNextRepeat_ms = 110;

bool has(std::span<const Input> inputs, Input input) {
    return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
}

bool works_panel(const Bindings& bindings, Input input) {
    constexpr std::array<Action, 4> kDials{Action::DialUp, Action::DialDown, Action::DialCoarser, Action::DialFiner};
    return std::any_of(kDials.begin(), kDials.end(), [&](Action dial) { return has(bindings.inputs_of(dial), input); });
}

// True for moves that depend on how far a stick is pushed; other moves and inputs are on or off.
bool is_gradual(Action move, Input input) {
    return input.device == Device::PadAxis && move <= Action::LookDown;
}

}  // namespace

void InputMapper::press(Input input) {
    if (holds(input)) return;
    held_.push_back(input);
    tapped_.push_back(input);
    if (input.device != Device::Script) since_.pressed = input;
    if (is_of_pad(input)) {
        pad_input_ = input;
        repeat_at_ms_ = 0;
    }
    act(input, false);
}

void InputMapper::repeat(Input input) {
    if (holds(input)) act(input, true);
}

void InputMapper::release(Input input) {
    std::erase(held_, input);
    if (pad_input_ == input) pad_input_.reset();
}

void InputMapper::move_axis(Input half, std::int32_t value) {
    if (half.device != Device::PadAxis || half.code >= axes_.size()) return;
    axes_[half.code] = std::clamp(value, 0, kFullAxis);
    if (value > kPressed) press(half);
    if (value < kReleased) release(half);
}

void InputMapper::click(Input button) {
    if (button.code > 2) return press(button);
    since_.pressed = button;
    if (button.code == 2) since_.menu.push_back(MenuAction::Back);
}

void InputMapper::release_pressed() {
    held_.clear();
    tapped_.clear();
    pad_input_.reset();
}

void InputMapper::release_all() {
    release_pressed();
    axes_.fill(0);
}

void InputMapper::release_pad() {
    std::erase_if(held_, is_of_pad);
    axes_.fill(0);
    pad_input_.reset();
}

void InputMapper::move_mouse(std::int32_t x, std::int32_t y) {
    constexpr std::int32_t kMost = 1 << 20;  // far more than a mouse counts between two polls
    since_.mouse_x = std::clamp(since_.mouse_x + std::clamp(x, -kMost, kMost), -kMost, kMost);
    since_.mouse_y = std::clamp(since_.mouse_y + std::clamp(y, -kMost, kMost), -kMost, kMost);
}

Controls InputMapper::take(std::uint64_t now_ms) {
    repeat_pad(now_ms);
    Controls controls = std::exchange(since_, {});
    controls.moves = moves(false);
    controls.panel_moves = moves(true);
    controls.walk_stick = {axis_of(Action::Right) - axis_of(Action::Left),
                           axis_of(Action::Forward) - axis_of(Action::Back)};
    controls.look_stick = {axis_of(Action::TurnRight) - axis_of(Action::TurnLeft),
                           axis_of(Action::LookUp) - axis_of(Action::LookDown)};
    controls.holds_button = holds(mouse_button(1));
    tapped_.clear();
    return controls;
}

Controls InputMapper::take(const PlatformInput& input, std::uint64_t now_ms) {
    for (const InputEvent& event : input.events) take(event);
    Controls controls = take(now_ms);
    static_cast<WindowInput&>(controls) = input;
    return controls;
}

std::int32_t InputMapper::longest_wait_ms() const {
    return pad_input_ ? static_cast<std::int32_t>(kNextRepeat_ms) : std::numeric_limits<std::int32_t>::max();
}

bool InputMapper::holds(Input input) const {
    return has(held_, input);
}

void InputMapper::take(const InputEvent& event) {
    switch (event.kind) {
        case InputEvent::Kind::Press:
            return press(event.input);
        case InputEvent::Kind::Repeat:
            return repeat(event.input);
        case InputEvent::Kind::Release:
            return release(event.input);
        case InputEvent::Kind::Click:
            return click(event.input);
        case InputEvent::Kind::Axis:
            return move_axis(event.input, event.x);
        case InputEvent::Kind::MouseMotion:
            return move_mouse(event.x, event.y);
        case InputEvent::Kind::ReleasePressed:
            return release_pressed();
        case InputEvent::Kind::ReleasePad:
            return release_pad();
        case InputEvent::Kind::ReleaseAll:
            return release_all();
    }
}

void InputMapper::act(Input input, bool is_repeated) {
    const std::optional<MenuAction> in_menu = menu_action_of(input);
    if (in_menu && (!is_repeated || *in_menu < MenuAction::Accept)) since_.menu.push_back(*in_menu);
    if (input.device == Device::Script && input.code >= kActionCount)
        since_.menu.push_back(static_cast<MenuAction>(input.code - kActionCount));
    if (is_reserved(input) && !is_repeated) since_.commands.push_back(Action::Menu);
    for (const ActionRow& row : all_actions())
        if (!is_move(row.action) && (!is_repeated || is_of_panel(row.action)) &&
            (scripted(row.action) == input || has(bindings_.inputs_of(row.action), input)))
            since_.commands.push_back(row.action);
}

// The system repeats keys, at the rate that the user has set; only the mapper repeats pad inputs.
void InputMapper::repeat_pad(std::uint64_t now_ms) {
    if (!pad_input_) return;
    if (repeat_at_ms_ == 0) repeat_at_ms_ = now_ms + kFirstRepeat_ms;
    if (now_ms < repeat_at_ms_) return;
    repeat(*pad_input_);
    repeat_at_ms_ = now_ms + kNextRepeat_ms;
}

std::int32_t InputMapper::axis_of(Action move) const {
    std::int32_t most = 0;
    for (const Input input : bindings_.inputs_of(move))
        if (is_gradual(move, input)) most = std::max(most, axes_[input.code]);
    return most;
}

bool InputMapper::is_on(Action move, bool by_panel_keys) const {
    if (!by_panel_keys && (holds(scripted(move)) || has(tapped_, scripted(move)))) return true;
    const std::span<const Input> inputs = bindings_.inputs_of(move);
    return std::any_of(inputs.begin(), inputs.end(), [&](Input input) {
        return !is_gradual(move, input) && (holds(input) || has(tapped_, input)) &&
               works_panel(bindings_, input) == by_panel_keys;
    });
}

Moves InputMapper::moves(bool by_panel_keys) const {
    Moves on;
    for (int i = 0; i < kMoveCount; ++i) {
        const auto move = static_cast<Action>(i);
        on.set(move, is_on(move, by_panel_keys));
    }
    return on;
}

bool Controls::has(Action command) const {
    return std::find(commands.begin(), commands.end(), command) != commands.end();
}

}  // namespace oblong
