#include "engine/platform/dos/pc.h"

#include <algorithm>
#include <array>
#include <utility>

namespace oblong::dos {
namespace {

constexpr std::int32_t kPointerSpeed = 4;  // pixels of 1600x1200 a count: 400 counts, two inches, are the width

// The USB HID usage of a key, from its scan code of set 1 without the release bit; `is_extended`: the code followed a
// byte E0h. 0: none.
std::uint16_t key_usage(std::uint8_t scan_code, bool is_extended) {
    // By rows of the keyboard: Escape to Backspace; Tab to Enter; Ctrl, A to `; Shift, \ to keypad *; Alt, Space, Caps
    // Lock; F1 to F10; Num and Scroll Lock; the keypad; the key beside the left Shift; F11 and F12.
    static constexpr std::array<std::uint8_t, 0x59> kUsages{
        0,   41, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 45,  46, 42,            //
        43,  20, 26, 8,  21, 23, 28, 24, 12, 18, 19, 47, 48,  40,                //
        224, 4,  22, 7,  9,  10, 11, 13, 14, 15, 51, 52, 53,                     //
        225, 49, 29, 27, 6,  25, 5,  17, 16, 54, 55, 56, 229, 85, 226, 44,  57,  //
        58,  59, 60, 61, 62, 63, 64, 65, 66, 67, 83, 71,                         //
        95,  96, 97, 86, 92, 93, 94, 87, 89, 90, 91, 98, 99,  0,  0,   100, 68, 69};
    // Keypad Enter, right Ctrl, keypad /, Print, right Alt, Home, Up, Page Up, Left, Right, End, Down, Page Down,
    // Insert, Delete.
    static constexpr std::pair<std::uint8_t, std::uint8_t> kExtended[] = {
        {0x1c, 88}, {0x1d, 228}, {0x35, 84}, {0x37, 70}, {0x38, 230}, {0x47, 74}, {0x48, 82}, {0x49, 75},
        {0x4b, 80}, {0x4d, 79},  {0x4f, 77}, {0x50, 81}, {0x51, 78},  {0x52, 73}, {0x53, 76}};
    if (!is_extended) return scan_code < kUsages.size() ? kUsages[scan_code] : 0;
    for (const auto& [code, usage] : kExtended)
        if (code == scan_code) return usage;
    return 0;
}

}  // namespace

std::uint64_t Pc::now_us() {
    std::uint64_t counts = 0;
    call(Call::Clock, &counts);
    return counts / kTimerHz * 1'000'000 + counts % kTimerHz * 1'000'000 / kTimerHz;
}

void Pc::take_key(std::uint16_t usage, bool is_released) {
    const Input key{Device::Key, usage};
    if (is_released) return held_.erase(usage) != 0 ? note(InputEvent::Kind::Release, key) : void();
    const bool is_new = held_.emplace(usage, true).second;  // the keyboard itself repeats
    note(is_new ? InputEvent::Kind::Press : InputEvent::Kind::Repeat, key);
}

void Pc::take_keys() {
    constexpr int kExtended = 0xe0, kReleased = 0x80;
    for (int byte = call(Call::Key); byte >= 0; byte = call(Call::Key)) {
        if (byte == kExtended) {
            is_extended_ = true;
            continue;
        }
        const std::uint16_t usage = key_usage(static_cast<std::uint8_t>(byte & ~kReleased), is_extended_);
        is_extended_ = false;
        if (usage != 0) take_key(usage, (byte & kReleased) != 0);
    }
}

void Pc::take_mouse() {
    MouseState mouse;
    call(Call::Mouse, &mouse);
    const bool has_moved = mouse.x != 0 || mouse.y != 0;
    if (has_moved && is_captured_) input_.events.push_back({InputEvent::Kind::MouseMotion, {}, mouse.x, mouse.y});
    if (has_moved && !is_captured_) {
        pointer_.x_px = std::clamp(pointer_.x_px + kPointerSpeed * mouse.x, 0, window_size().width_px - 1);
        pointer_.y_px = std::clamp(pointer_.y_px + kPointerSpeed * mouse.y, 0, window_size().height_px - 1);
        pointer_.has_moved = true;
    }
    for (std::uint16_t number = 1; number <= 3; ++number) {
        const std::uint32_t bit = 1u << (number - 1);
        if (((mouse.buttons ^ buttons_) & bit) == 0) continue;
        const bool is_pressed = (mouse.buttons & bit) != 0;
        if (!is_pressed)
            note(InputEvent::Kind::Release, mouse_button(number));
        else
            note(is_captured_ ? InputEvent::Kind::Press : InputEvent::Kind::Click, mouse_button(number));
        pointer_.is_pressed |= is_pressed && !is_captured_ && number == 1;
    }
    buttons_ = mouse.buttons;
}

PlatformInput Pc::poll() {
    take_keys();
    take_mouse();
    if (!is_captured_) input_.pointer = pointer_;
    pointer_.has_moved = pointer_.is_pressed = false;
    return std::exchange(input_, {});
}

// Mouse motion before the capture does not turn the view.
void Pc::capture_mouse(bool is_captured) {
    if (is_captured_ == is_captured) return;
    take_mouse();
    input_.events.clear();
    is_captured_ = is_captured;
    note(InputEvent::Kind::ReleasePressed, {});
}

bool Pc::wait_for_input(std::int32_t timeout_ms) {
    const std::uint64_t until_us = now_us() + static_cast<std::uint64_t>(std::max(timeout_ms, 0)) * 1000;
    while (now_us() < until_us) {
        take_keys();
        take_mouse();
        if (!input_.events.empty() || pointer_.has_moved) return true;
        call(Call::Idle);
    }
    return false;
}

// Does not wait after a picture that took longer than a frame of the display.
void Pc::present(Framebuffer picture, const Palette& palette, const PresentRect&) {
    constexpr std::uint64_t kFrame_us = 1'000'000 / 70;
    if (settings_.waits_for_display && now_us() - shown_us_ < kFrame_us) vga_.wait_for_retrace();
    shown_us_ = now_us();
    vga_.show(picture, palette);
}

}  // namespace oblong::dos
