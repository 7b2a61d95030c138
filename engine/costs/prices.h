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
//   demo     1991           -7.2,  -5.9,  -5.4,  -5.4,  -5.3
//   demo     1991+none      +7.1,  +5.6,  +5.6,  +5.5,  +5.3
//   demo     1994           -5.4,  -4.7,  -4.6,  -4.9,  -4.7
//   demo     1994+none     +11.7,  +9.7,  +8.1,  +7.1,  +6.9
//   demo     1996           -5.3,  -4.4,  -3.5,  -2.9,  -3.5
//   demo     1996+none     +10.2,  +8.5,  +8.2,  +8.8,  +7.3
//   demo     bounded        -6.0,  -6.7,  -6.9,  -7.6,  -6.7
//   demo     bounded+none   +9.3,  +5.2,  +3.5,  +1.9,  +2.5
//   demo     exact          -9.4,  -8.3,  -7.8,  -7.8,  -7.8
//   demo     exact+none     +3.3,  -2.0,  -2.8,  -4.4,  -2.8
//   demo     pixel          -5.2,  -4.8,  -4.9,  -5.4,  -5.2
//   demo     pixel+none    +11.3,  +9.1,  +7.4,  +6.3,  +6.0
//   dm4      1991           -1.6,  -5.4,  -2.6,  -2.3,  -2.9
//   dm4      1991+none      +4.7,  +5.1,  +4.2,  +3.6,  +3.4
//   dm4      1994           -1.6,  -4.7,  -2.7,  -2.5,  -3.2
//   dm4      1994+none      +4.8,  +5.2,  +3.3,  +2.6,  +2.3
//   dm4      1996           +0.9,  -1.8,  +0.8,  +1.6,  +0.6
//   dm4      1996+none      +6.0,  +6.7,  +5.4,  +5.6,  +4.9
//   dm4      bounded        +0.3,  -2.1,  -1.2,  -2.1,  -1.6
//   dm4      bounded+none   +4.8,  +5.2,  +3.5,  +2.8,  +3.4
//   dm4      exact          -5.8,  -5.5,  -5.6,  -6.2,  -6.0
//   dm4      exact+none     +1.9,  -1.5,  -1.6,  -1.8,  -1.7
//   dm4      pixel          +2.0,  -1.3,  +1.9,  +2.0,  +1.3
//   dm4      pixel+none     +7.1,  +8.9,  +6.9,  +6.2,  +5.9
//   e1m7     1991           -0.4,  +1.5,  +1.8,  +2.3,  +1.7
//   e1m7     1991+none      +4.1,  +3.0,  +2.9,  +3.7,  +2.7
//   e1m7     1994           +4.1,  +5.0,  +4.1,  +4.2,  +3.9
//   e1m7     1994+none      +7.4,  +5.5,  +4.1,  +4.7,  +4.0
//   e1m7     1996           +3.9,  +4.3,  +3.9,  +4.3,  +3.8
//   e1m7     1996+none      +8.3,  +6.7,  +5.5,  +5.2,  +5.0
//   e1m7     bounded        +3.7,  +1.5,  -1.3,  -2.9,  -1.6
//   e1m7     bounded+none   +7.4,  +4.2,  +2.9,  -4.0,  -2.5
//   e1m7     exact          -2.3,  -3.2,  -5.0,  -6.8,  -5.4
//   e1m7     exact+none     +3.5,  +1.9,  -3.1,  -4.5,  -3.3
//   e1m7     pixel          +4.2,  +4.9,  +3.6,  +3.1,  +3.1
//   e1m7     pixel+none     +8.4,  +6.5,  +5.1,  +4.4,  +4.4
//   end      1991           -5.6, -10.0,  -5.1,  -4.1,  -5.3
//   end      1991+none      +5.7,  +5.4,  +5.2,  +5.1,  +4.6
//   end      1994           -4.8,  -9.0,  -5.3,  -4.4,  -5.6
//   end      1994+none      +4.4,  +4.5,  +3.6,  +4.0,  +3.5
//   end      1996           -2.5,  -4.8,  -1.7,  +1.2,  -1.4
//   end      1996+none      +4.3,  +4.8,  +4.4,  +4.6,  +4.3
//   end      bounded        -2.2,  -4.6,  -2.4,  -3.0,  -2.6
//   end      bounded+none   +2.6,  +2.3,  -1.6,  -4.2,  -2.3
//   end      exact          -9.7,  -8.3,  -8.4,  -9.4,  -9.0
//   end      exact+none     +1.7,  -1.7,  -1.6,  -2.1,  -1.7
//   end      pixel          -1.9,  -3.8,  -1.1,  -1.0,  -1.5
//   end      pixel+none     +4.8,  +6.8,  +5.5,  +4.7,  +4.6
// presets, at most: 11.7, 10.0, 8.4, 9.4, 9.0
// any setting, at most: 12.0, 12.2, 11.5, 15.7, 11.9
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {5084, 7830, 34947, 21170, 12880}},
    {"vertices", {1942, 2785, 12655, 7284, 4472}},
    {"clipped corners", {6324, 13055, 51717, 30736, 19073}},
    {"stepped edge rows", {190, 342, 1272, 610, 456}},
    {"spans", {646, 145, 3039, 1975, 1260}},
    {"surfaces", {45468, 79016, 286920, 154940, 104239}},
    {"mip spans", {940, 4245, 17523, 11224, 7308}},
    {"exact spans", {2197, 6066, 31486, 22324, 12161}},
    {"affine blocks", {559, 987, 4880, 2721, 2019}},
    {"even blocks", {622, 1174, 5341, 2975, 2063}},
    {"bounded blocks", {682, 1363, 6221, 3451, 2379}},
    {"texel-bounded blocks", {1803, 3564, 16788, 10473, 6637}},
    {"exact blocks", {720, 1114, 4513, 2304, 1699}},
    {"odd blocks", {230, 724, 2486, 1474, 981}},
    {"divisions", {471, 838, 3890, 2539, 2000}},
    {"table lookups", {613, 1133, 4667, 2928, 1942}},
    {"Newton steps", {73, 154, 979, 967, 445}},
    {"second Newton steps", {103, 466, 2397, 2055, 1140}},
    {"textured pixels", {32, 61, 275, 94, 92}},
    {"divided pixels", {183, 529, 2734, 2003, 1072}},
    {"exact pixels", {135, 384, 1981, 1414, 772}},
    {"shared divisions", {558, 1499, 7555, 5362, 3546}},
    {"sky directions", {2077, 9358, 37252, 22385, 15374}},
    {"liquid pixels", {37, 87, 273, 123, 94}},
    {"translucent pixels", {209, 184, 672, 225, 221}},
    {"pixels of moving lights", {132, 225, 933, 531, 356}},
    {"fogged pixels", {727, 1765, 7341, 4388, 2861}},
    {"sprite pixels", {466, 939, 4158, 2215, 1451}},
    {"mirrored pixels", {307, 496, 1858, 1032, 650}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {15664, 28278, 133146, 87643, 51052}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 244, 106, 92}},
    {"dithered texels", {74, 60, 281, 164, 92}},
}};

}  // namespace oblong
