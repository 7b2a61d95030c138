#include "engine/platform/input.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {
namespace {

// The names of a device's codes from `first` on, with commas between them; "": a code without a name.
struct NamedCodes {
    Device device;
    std::uint16_t first;
    std::string_view names;
};
constexpr std::array<NamedCodes, 7> kNamedCodes{{
    {Device::Key, 4,  // USB HID Usage Tables, keyboard page
     "A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,1,2,3,4,5,6,7,8,9,0,Enter,Escape,Backspace,Tab,Space,Minus,"
     "Equals,Left Bracket,Right Bracket,Backslash,Hash,Semicolon,Apostrophe,Grave,Comma,Period,Slash,Caps Lock,F1,F2,"
     "F3,F4,F5,F6,F7,F8,F9,F10,F11,F12,Print Screen,Scroll Lock,Pause,Insert,Home,Page Up,Delete,End,Page Down,Right,"
     "Left,Down,Up,Num Lock,Keypad Slash,Keypad Star,Keypad Minus,Keypad Plus,Keypad Enter,Keypad 1,Keypad 2,Keypad 3,"
     "Keypad 4,Keypad 5,Keypad 6,Keypad 7,Keypad 8,Keypad 9,Keypad 0,Keypad Period,Less,Application,Power,"
     "Keypad Equals,F13,F14,F15,F16,F17,F18,F19,F20,F21,F22,F23,F24"},
    {Device::Key, 127, "Mute,Volume Up,Volume Down,,,,Keypad Comma"},
    {Device::Key, 224, "Left Ctrl,Left Shift,Left Alt,Left Super,Right Ctrl,Right Shift,Right Alt,Right Super"},
    {Device::Key, 257, "Mode"},
    {Device::MouseWheel, 0, "Up,Down,Left,Right"},
    {Device::PadButton, 0,
     "A,B,X,Y,Back,Guide,Start,Left Stick,Right Stick,Left Shoulder,Right Shoulder,Up,Down,Left,Right,Misc,Paddle 1,"
     "Paddle 2,Paddle 3,Paddle 4,Touchpad"},
    {Device::PadAxis, 0,
     "Left Stick Left,Left Stick Right,Left Stick Up,Left Stick Down,Right Stick Left,Right Stick Right,Right Stick Up,"
     "Right Stick Down,,Left Trigger,,Right Trigger"},
}};

// By Device. Keys with a name have none; other keys and mouse buttons are named by their numbers.
constexpr std::array<std::string_view, 5> kPrefixes{"Key ", "Mouse ", "Wheel ", "Pad ", "Pad "};
constexpr std::uint16_t kMostKeys = 512, kMostButtons = 32;

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter == '-' ? ' ' : letter;
}

bool is_same_name(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

// Removes the prefix of a device; false: the name has another.
bool take_prefix(Device device, std::string_view& name) {
    const std::string_view prefix = item(kPrefixes, device);
    if (!is_same_name(name.substr(0, prefix.size()), prefix)) return false;
    name.remove_prefix(prefix.size());
    return true;
}

// The first input with a name for which is_meant(input, name) is true; the name is "" if there is none.
template <class IsMeant>
std::pair<Input, std::string_view> find_named(IsMeant is_meant) {
    for (auto [device, code, names] : kNamedCodes)
        for (; !names.empty(); ++code) {
            const std::string_view name = names.substr(0, names.find(','));
            names.remove_prefix(std::min(name.size() + 1, names.size()));
            if (!name.empty() && is_meant(Input{device, code}, name)) return {{device, code}, name};
        }
    return {};
}

// A decimal number in [1, end); 0 for anything else.
std::uint16_t number_in(std::string_view text, std::uint16_t end) {
    if (text.size() > 3 || text.find_first_not_of("0123456789") != std::string_view::npos) return 0;
    std::uint16_t number = 0;
    for (const char digit : text) number = static_cast<std::uint16_t>(number * 10 + (digit - '0'));
    return number < end ? number : std::uint16_t{0};
}

}  // namespace

bool is_reserved(Input input) {
    constexpr Input kEscape{Device::Key, 41};
    return input == kEscape || input == pad_button(PadButton::Start);
}

std::string name_of(Input input) {
    const std::string name(find_named([&](Input each, std::string_view) { return each == input; }).second);
    if (input.device == Device::Key && !name.empty()) return name;
    return std::string(item(kPrefixes, input.device)) + (name.empty() ? std::to_string(input.code) : name);
}

std::string name_of_letter(std::int32_t code_point) {
    if (code_point >= 'a' && code_point <= 'z') code_point += 'A' - 'a';
    if (code_point > ' ' && code_point <= '~') return {static_cast<char>(code_point)};
    if (code_point < 0xc0 || code_point > 0x17f) return {};
    return {static_cast<char>(0xc0 | code_point >> 6), static_cast<char>(0x80 | (code_point & 0x3f))};  // UTF-8
}

Input input_named(std::string_view name) {
    const auto [input, known] = find_named([&](Input each, std::string_view its_name) {
        std::string_view rest = name;
        return (each.device == Device::Key || take_prefix(each.device, rest)) && is_same_name(its_name, rest);
    });
    if (!known.empty()) return input;
    for (const auto& [device, end] : {std::pair{Device::MouseButton, kMostButtons}, {Device::Key, kMostKeys}}) {
        std::string_view rest = name;
        const std::uint16_t number = take_prefix(device, rest) ? number_in(rest, end) : std::uint16_t{0};
        if (number > 0) return {device, number};
    }
    throw InputError("input", "'" + std::string(name) +
                                  "' is no key or button, expected a name such as W, Left-Shift, Mouse-1 or Pad-A");
}

}  // namespace oblong
