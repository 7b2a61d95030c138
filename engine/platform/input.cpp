#include "engine/platform/input.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

using CodeName = std::pair<std::uint16_t, std::string_view>;

// USB HID Usage Tables, keyboard page, without letters, digits and function keys.
constexpr std::array<CodeName, 65> kKeyNames{{
    {40, "Enter"},
    {41, "Escape"},
    {42, "Backspace"},
    {43, "Tab"},
    {44, "Space"},
    {45, "Minus"},
    {46, "Equals"},
    {47, "Left Bracket"},
    {48, "Right Bracket"},
    {49, "Backslash"},
    {50, "Hash"},
    {51, "Semicolon"},
    {52, "Apostrophe"},
    {53, "Grave"},
    {54, "Comma"},
    {55, "Period"},
    {56, "Slash"},
    {57, "Caps Lock"},
    {70, "Print Screen"},
    {71, "Scroll Lock"},
    {72, "Pause"},
    {73, "Insert"},
    {74, "Home"},
    {75, "Page Up"},
    {76, "Delete"},
    {77, "End"},
    {78, "Page Down"},
    {79, "Right"},
    {80, "Left"},
    {81, "Down"},
    {82, "Up"},
    {83, "Num Lock"},
    {84, "Keypad Slash"},
    {85, "Keypad Star"},
    {86, "Keypad Minus"},
    {87, "Keypad Plus"},
    {88, "Keypad Enter"},
    {89, "Keypad 1"},
    {90, "Keypad 2"},
    {91, "Keypad 3"},
    {92, "Keypad 4"},
    {93, "Keypad 5"},
    {94, "Keypad 6"},
    {95, "Keypad 7"},
    {96, "Keypad 8"},
    {97, "Keypad 9"},
    {98, "Keypad 0"},
    {99, "Keypad Period"},
    {100, "Less"},
    {101, "Application"},
    {103, "Keypad Equals"},
    {127, "Mute"},
    {128, "Volume Up"},
    {129, "Volume Down"},
    {133, "Keypad Comma"},
    {224, "Left Ctrl"},
    {225, "Left Shift"},
    {226, "Left Alt"},
    {227, "Left Super"},
    {228, "Right Ctrl"},
    {229, "Right Shift"},
    {230, "Right Alt"},
    {231, "Right Super"},
    {257, "Mode"},
    {102, "Power"},
}};
constexpr std::array<CodeName, 4> kWheelNames{{{0, "Up"}, {1, "Down"}, {2, "Left"}, {3, "Right"}}};
constexpr std::array<CodeName, 21> kPadButtonNames{{
    {0, "A"},
    {1, "B"},
    {2, "X"},
    {3, "Y"},
    {4, "Back"},
    {5, "Guide"},
    {6, "Start"},
    {7, "Left Stick"},
    {8, "Right Stick"},
    {9, "Left Shoulder"},
    {10, "Right Shoulder"},
    {11, "Up"},
    {12, "Down"},
    {13, "Left"},
    {14, "Right"},
    {15, "Misc"},
    {16, "Paddle 1"},
    {17, "Paddle 2"},
    {18, "Paddle 3"},
    {19, "Paddle 4"},
    {20, "Touchpad"},
}};
constexpr std::array<CodeName, 10> kPadAxisNames{{
    {0, "Left Stick Left"},
    {1, "Left Stick Right"},
    {2, "Left Stick Up"},
    {3, "Left Stick Down"},
    {4, "Right Stick Left"},
    {5, "Right Stick Right"},
    {6, "Right Stick Up"},
    {7, "Right Stick Down"},
    {9, "Left Trigger"},
    {11, "Right Trigger"},
}};

constexpr std::uint16_t kFirstLetter = 4, kFirstDigit = 30, kZero = 39, kFirstFunctionKey = 58, kF13 = 104;
constexpr std::uint16_t kMostKeys = 512, kMostButtons = 32;

struct DeviceNames {
    Device device;
    std::string_view prefix;
    std::span<const CodeName> names;
    std::uint16_t first = 1, end = 0;  // codes without a name, which are named by their numbers
};
constexpr std::array<DeviceNames, 5> kDevices{{
    {Device::MouseButton, "Mouse ", {}, 1, kMostButtons},
    {Device::MouseWheel, "Wheel ", kWheelNames},
    {Device::PadButton, "Pad ", kPadButtonNames},
    {Device::PadAxis, "Pad ", kPadAxisNames},
    {Device::Key, "Key ", {}, 1, kMostKeys},
}};

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter == '-' ? ' ' : letter;
}

bool is_same_name(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string key_name(std::uint16_t code) {
    for (const auto& [key, name] : kKeyNames)
        if (key == code) return std::string(name);
    if (code >= kFirstLetter && code < kFirstDigit) return {static_cast<char>('A' + code - kFirstLetter)};
    if (code >= kFirstDigit && code <= kZero) return std::to_string((code - kFirstDigit + 1) % 10);
    if (code >= kFirstFunctionKey && code < kFirstFunctionKey + 12)
        return "F" + std::to_string(code - kFirstFunctionKey + 1);
    if (code >= kF13 && code < kF13 + 12) return "F" + std::to_string(code - kF13 + 13);
    return "";
}

// A decimal number in [first, end).
std::optional<std::uint16_t> number_in(std::string_view text, std::uint16_t first, std::uint16_t end) {
    if (text.empty() || text.size() > 3 || text.find_first_not_of("0123456789") != std::string_view::npos) return {};
    std::uint16_t number = 0;
    for (const char digit : text) number = static_cast<std::uint16_t>(number * 10 + (digit - '0'));
    if (number < first || number >= end) return {};
    return number;
}

std::uint16_t function_key(std::uint16_t number) {
    return static_cast<std::uint16_t>(number <= 12 ? kFirstFunctionKey + number - 1 : kF13 + number - 13);
}

std::optional<std::uint16_t> key_named(std::string_view name) {
    for (const auto& [code, known] : kKeyNames)
        if (is_same_name(known, name)) return code;
    if (name.empty()) return {};
    const char first = lower(name.front());
    if (name.size() == 1 && first >= 'a' && first <= 'z')
        return static_cast<std::uint16_t>(kFirstLetter + (first - 'a'));
    if (name.size() == 1 && first >= '0' && first <= '9')
        return static_cast<std::uint16_t>(kFirstDigit + (first - '0' + 9) % 10);
    const auto number = first == 'f' ? number_in(name.substr(1), 1, 25) : std::nullopt;
    if (number) return function_key(*number);
    return {};
}

std::optional<std::uint16_t> code_in(const DeviceNames& device, std::string_view name) {
    if (name.size() < device.prefix.size() || !is_same_name(name.substr(0, device.prefix.size()), device.prefix))
        return {};
    name.remove_prefix(device.prefix.size());
    for (const auto& [code, known] : device.names)
        if (is_same_name(known, name)) return code;
    return number_in(name, device.first, device.end);
}

}  // namespace

bool is_reserved(Input input) {
    constexpr Input kEscape{Device::Key, 41};
    return input == kEscape || input == pad_button(PadButton::Start);
}

std::string name_of(Input input) {
    if (input.device == Device::Key) {
        const std::string name = key_name(input.code);
        return name.empty() ? "Key " + std::to_string(input.code) : name;
    }
    const auto found = std::find_if(kDevices.begin(), kDevices.end(),
                                    [&](const DeviceNames& device) { return device.device == input.device; });
    for (const auto& [code, name] : found->names)
        if (code == input.code) return std::string(found->prefix) + std::string(name);
    return std::string(found->prefix) + std::to_string(input.code);
}

Input input_named(std::string_view name) {
    if (const auto code = key_named(name)) return {Device::Key, *code};
    for (const DeviceNames& device : kDevices)
        if (const auto code = code_in(device, name)) return {device.device, *code};
    throw InputError("input", "'" + std::string(name) +
                                  "' is no key or button, expected a name such as W, Left-Shift, Mouse-1 or Pad-A");
}

}  // namespace oblong
