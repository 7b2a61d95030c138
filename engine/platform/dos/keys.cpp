#include "engine/platform/dos/keys.h"

#include <array>
#include <utility>

namespace oblong::dos {

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

}  // namespace oblong::dos
