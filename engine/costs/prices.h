#pragma once

#include <array>
#include <string_view>

#include "engine/costs/costs.h"

namespace oblong {

struct EventPrice {
    std::string_view event;
    std::array<std::int32_t, kCurrencyCount> prices_10;  ///< tenths, in the order of Currency
};

// Prices and errors are written by `tests/operations/costs.py fit`. By how much the prices of a level's frames are off,
// in the order of Currency, per cent:
//   demo     1991           -6.8,  -5.5,  -5.0,  -5.0,  -4.9
//   demo     1991+none      +8.6,  +6.6,  +6.8,  +6.4,  +6.0
//   demo     1994           -6.0,  -5.2,  -5.0,  -5.2,  -5.0
//   demo     1994+none     +11.6,  +9.3,  +7.8,  +6.8,  +6.7
//   demo     1996           -5.7,  -4.7,  -3.9,  -3.2,  -3.7
//   demo     1996+none     +10.4,  +8.4,  +8.2,  +8.8,  +7.3
//   demo     bounded        -6.5,  -7.2,  -7.2,  -7.8,  -7.0
//   demo     bounded+none   +9.4,  +5.1,  +3.5,  +2.0,  +2.7
//   demo     exact          -9.6,  -8.0,  -7.4,  -7.4,  -7.5
//   demo     exact+none     +3.5,  -1.8,  -2.6,  -4.2,  -2.6
//   demo     pixel          -5.7,  -5.3,  -5.3,  -5.6,  -5.4
//   demo     pixel+none    +11.4,  +8.9,  +7.3,  +6.3,  +6.0
//   dm4      1991           -1.9,  -5.4,  -2.7,  -2.4,  -3.0
//   dm4      1991+none      +5.2,  +5.5,  +4.4,  +3.7,  +3.3
//   dm4      1994           -1.5,  -4.8,  -2.7,  -2.7,  -3.3
//   dm4      1994+none      +4.8,  +4.9,  +3.1,  +2.3,  +2.2
//   dm4      1996           +1.1,  -1.8,  +1.0,  +1.7,  +0.8
//   dm4      1996+none      +6.2,  +6.6,  +5.5,  +5.7,  +5.1
//   dm4      bounded        +0.3,  -2.2,  -1.1,  -2.0,  -1.4
//   dm4      bounded+none   +4.7,  +4.9,  +3.5,  +2.8,  +3.5
//   dm4      exact          -5.8,  -5.4,  -5.4,  -6.1,  -5.8
//   dm4      exact+none     +1.8,  -1.4,  -1.5,  -1.8,  -1.6
//   dm4      pixel          +2.1,  -1.3,  +2.0,  +2.1,  +1.4
//   dm4      pixel+none     +7.2,  +8.7,  +6.9,  +6.2,  +6.0
//   e1m7     1991           +0.4,  +1.5,  +1.9,  +2.5,  +1.9
//   e1m7     1991+none      +4.9,  +3.3,  +3.0,  +3.3,  +2.4
//   e1m7     1994           +4.2,  +4.9,  +4.1,  +4.1,  +3.8
//   e1m7     1994+none      +7.4,  +5.0,  +3.7,  +4.2,  +3.7
//   e1m7     1996           +4.2,  +4.3,  +4.1,  +4.4,  +3.9
//   e1m7     1996+none      +8.5,  +6.5,  +5.5,  +5.3,  +5.1
//   e1m7     bounded        +3.9,  +1.6,  -1.1,  -2.8,  -1.5
//   e1m7     bounded+none   +7.5,  +4.0,  +2.8,  -4.0,  +2.6
//   e1m7     exact          -2.3,  -3.0,  -4.8,  -6.6,  -5.2
//   e1m7     exact+none     +3.4,  +1.9,  -3.0,  -4.4,  -3.2
//   e1m7     pixel          +4.5,  +5.0,  +3.8,  +3.2,  +3.2
//   e1m7     pixel+none     +8.5,  +6.3,  +5.1,  +4.4,  +4.5
//   end      1991           -5.5, -10.2,  -5.5,  -4.5,  -5.9
//   end      1991+none      +5.3,  +4.6,  +4.5,  +4.6,  +4.1
//   end      1994           -4.9,  -9.3,  -5.5,  -4.7,  -5.8
//   end      1994+none      +4.3,  +3.9,  +3.2,  +3.4,  +3.1
//   end      1996           -2.4,  -4.8,  -1.6,  +1.1,  -1.4
//   end      1996+none      +4.3,  +4.6,  +4.3,  +4.4,  +4.3
//   end      bounded        -2.2,  -4.7,  -2.4,  -3.0,  -2.6
//   end      bounded+none   +2.5,  +2.0,  -1.7,  -4.3,  -2.3
//   end      exact          -9.7,  -8.3,  -8.3,  -9.3,  -8.9
//   end      exact+none     +1.5,  -1.7,  -1.5,  -2.0,  -1.6
//   end      pixel          -1.9,  -4.0,  -1.1,  -1.2,  -1.5
//   end      pixel+none     +4.8,  +6.4,  +5.3,  +4.6,  +4.5
// presets, at most: 11.6, 10.2, 8.3, 9.3, 8.9
// any setting, at most: 12.0, 12.2, 11.0, 14.8, 11.2
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {5082, 8020, 35546, 21587, 13079}},
    {"vertices", {1907, 3201, 14142, 8151, 4908}},
    {"clipped corners", {6517, 13685, 54391, 32013, 19895}},
    {"stepped edge rows", {180, 293, 925, 351, 302}},
    {"spans", {667, 164, 3151, 1991, 1282}},
    {"surfaces", {45487, 79052, 286216, 154443, 104059}},
    {"mip spans", {934, 4224, 17435, 11172, 7272}},
    {"exact spans", {2251, 6149, 31830, 22564, 12303}},
    {"affine blocks", {534, 947, 4734, 2698, 1984}},
    {"even blocks", {616, 1165, 5313, 2976, 2058}},
    {"bounded blocks", {671, 1350, 6183, 3457, 2375}},
    {"texel-bounded blocks", {1785, 3542, 16736, 10475, 6626}},
    {"exact blocks", {719, 1114, 4524, 2319, 1704}},
    {"odd blocks", {195, 692, 2275, 1371, 906}},
    {"block divisions", {483, 853, 3954, 2585, 2029}},
    {"table lookups", {598, 1114, 4517, 2796, 1882}},
    {"Newton steps", {91, 174, 1111, 1075, 497}},
    {"second Newton steps", {104, 468, 2405, 2062, 1144}},
    {"textured pixels", {32, 61, 276, 94, 92}},
    {"divided pixels", {184, 531, 2738, 2003, 1073}},
    {"exact pixels", {135, 384, 1980, 1412, 772}},
    {"shared divisions", {558, 1498, 7555, 5361, 3546}},
    {"sky directions", {2137, 9433, 37581, 22449, 15409}},
    {"liquid pixels", {37, 87, 274, 123, 94}},
    {"translucent pixels", {204, 177, 645, 213, 213}},
    {"pixels of moving lights", {178, 303, 1250, 707, 471}},
    {"fogged pixels", {802, 1943, 8086, 4840, 3156}},
    {"sprite pixels", {235, 470, 2162, 933, 668}},
    {"mirrored pixels", {320, 506, 1861, 998, 644}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {17922, 31993, 147973, 95170, 56209}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 243, 105, 91}},
    {"dithered texels", {74, 60, 281, 164, 92}},
}};

}  // namespace oblong
