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
//   demo     1991           -6.3,  -5.1,  -4.5,  -4.7,  -4.6
//   demo     1991+none      +8.7,  +7.0,  +7.1,  +6.8,  +6.3
//   demo     1994           -5.4,  -4.9,  -4.7,  -5.1,  -4.8
//   demo     1994+none     +11.7,  +9.4,  +7.8,  +6.8,  +6.6
//   demo     1996           -5.2,  -4.3,  -3.5,  -2.9,  -3.4
//   demo     1996+none     +10.4,  +8.5,  +8.3,  +8.9,  +7.4
//   demo     bounded        -5.9,  -6.7,  -6.8,  -7.5,  -6.6
//   demo     bounded+none   +9.4,  +5.1,  +3.6,  +2.0,  +2.7
//   demo     exact          -9.3,  -8.2,  -7.7,  -7.8,  -7.8
//   demo     exact+none     +3.5,  -2.0,  -2.7,  -4.4,  -2.7
//   demo     pixel          -5.1,  -4.8,  -4.9,  -5.3,  -5.1
//   demo     pixel+none    +11.4,  +9.0,  +7.4,  +6.3,  +6.1
//   dm4      1991           -1.9,  -5.4,  -2.7,  -2.3,  -2.9
//   dm4      1991+none      +5.3,  +5.6,  +4.5,  +3.9,  +3.4
//   dm4      1994           -1.5,  -5.1,  -2.9,  -3.0,  -3.5
//   dm4      1994+none      +4.8,  +4.7,  +3.0,  +2.1,  +2.0
//   dm4      1996           +1.0,  -1.9,  +0.9,  +1.6,  +0.7
//   dm4      1996+none      +6.1,  +6.6,  +5.5,  +5.6,  +5.1
//   dm4      bounded        +0.3,  -2.3,  -1.1,  -2.0,  -1.5
//   dm4      bounded+none   +4.7,  +5.0,  +3.6,  +2.8,  +3.5
//   dm4      exact          -5.7,  -5.5,  -5.5,  -6.2,  -5.9
//   dm4      exact+none     +2.1,  -1.5,  -1.6,  -1.8,  -1.7
//   dm4      pixel          +2.1,  -1.4,  +2.0,  +2.0,  +1.4
//   dm4      pixel+none     +7.2,  +8.8,  +7.0,  +6.2,  +6.0
//   e1m7     1991           -0.3,  +1.5,  +2.0,  +2.6,  +2.0
//   e1m7     1991+none      +4.9,  +3.7,  +3.4,  +3.8,  +2.8
//   e1m7     1994           +4.1,  +4.8,  +3.9,  +3.9,  +3.7
//   e1m7     1994+none      +7.4,  +5.2,  +3.9,  +4.3,  +3.7
//   e1m7     1996           +4.1,  +4.3,  +4.0,  +4.3,  +3.9
//   e1m7     1996+none      +8.5,  +6.7,  +5.7,  +5.4,  +5.2
//   e1m7     bounded        +3.8,  +1.5,  -1.2,  -3.0,  -1.6
//   e1m7     bounded+none   +7.5,  +4.2,  +3.0,  -4.0,  +2.7
//   e1m7     exact          -2.3,  -3.1,  -5.0,  -6.8,  -5.3
//   e1m7     exact+none     +3.5,  +1.9,  -3.0,  -4.4,  -3.3
//   e1m7     pixel          +4.4,  +4.9,  +3.7,  +3.1,  +3.2
//   e1m7     pixel+none     +8.6,  +6.5,  +5.3,  +4.5,  +4.6
//   end      1991           -5.4, -10.2,  -5.3,  -4.3,  -5.8
//   end      1991+none      +5.4,  +5.1,  +5.0,  +5.0,  +4.5
//   end      1994           -4.8,  -9.4,  -5.6,  -4.9,  -5.9
//   end      1994+none      +4.3,  +4.1,  +3.3,  +3.4,  +3.1
//   end      1996           -2.3,  -4.9,  -1.6,  +1.1,  -1.3
//   end      1996+none      +4.3,  +4.7,  +4.4,  +4.5,  +4.4
//   end      bounded        -2.1,  -4.7,  -2.4,  -3.0,  -2.6
//   end      bounded+none   +2.6,  +2.1,  -1.6,  -4.3,  -2.3
//   end      exact          -9.6,  -8.3,  -8.4,  -9.4,  -9.0
//   end      exact+none     +1.8,  -1.7,  -1.6,  -2.1,  -1.7
//   end      pixel          -1.8,  -4.0,  -1.1,  -1.1,  -1.5
//   end      pixel+none     +4.9,  +6.6,  +5.5,  +4.7,  +4.6
// presets, at most: 11.7, 10.2, 8.4, 9.4, 9.0
// any setting, at most: 12.0, 12.2, 11.2, 15.2, 11.6
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {5046, 7724, 34510, 21009, 12749}},
    {"vertices", {1914, 2798, 12741, 7347, 4491}},
    {"clipped corners", {6339, 13157, 52053, 30810, 19153}},
    {"stepped edge rows", {183, 301, 977, 389, 325}},
    {"spans", {663, 155, 3108, 1980, 1270}},
    {"surfaces", {45601, 78973, 286398, 154539, 104269}},
    {"mip spans", {938, 4240, 17498, 11208, 7298}},
    {"exact spans", {2237, 6107, 31657, 22432, 12223}},
    {"affine blocks", {538, 950, 4729, 2673, 1971}},
    {"even blocks", {617, 1166, 5323, 2978, 2060}},
    {"bounded blocks", {674, 1353, 6202, 3461, 2378}},
    {"texel-bounded blocks", {1786, 3541, 16727, 10460, 6619}},
    {"exact blocks", {718, 1112, 4515, 2312, 1700}},
    {"odd blocks", {210, 699, 2345, 1397, 927}},
    {"divisions", {482, 859, 3968, 2592, 2034}},
    {"table lookups", {607, 1129, 4596, 2857, 1914}},
    {"Newton steps", {82, 164, 1048, 1025, 472}},
    {"second Newton steps", {105, 468, 2409, 2065, 1145}},
    {"textured pixels", {32, 61, 276, 94, 92}},
    {"divided pixels", {184, 531, 2740, 2005, 1073}},
    {"exact pixels", {136, 385, 1983, 1414, 773}},
    {"shared divisions", {557, 1501, 7558, 5364, 3549}},
    {"sky directions", {2079, 9370, 37286, 22401, 15377}},
    {"liquid pixels", {37, 86, 273, 122, 94}},
    {"translucent pixels", {206, 179, 658, 219, 217}},
    {"pixels of moving lights", {149, 255, 1059, 605, 403}},
    {"fogged pixels", {723, 1762, 7325, 4380, 2855}},
    {"sprite pixels", {252, 554, 2600, 1321, 880}},
    {"mirrored pixels", {310, 498, 1837, 994, 636}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {15683, 28383, 133608, 87983, 51261}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 244, 106, 92}},
    {"dithered texels", {74, 60, 281, 164, 92}},
}};

}  // namespace oblong
