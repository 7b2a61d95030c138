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
//   demo     1991           -4.1,  +4.4,  +3.9,  -3.8,  +3.9
//   demo     1991+none      +7.8,  +5.8,  +5.0,  +4.6,  +4.5
//   demo     1994           +5.8,  +6.0,  +5.2,  +4.7,  +4.7
//   demo     1994+none     +10.9,  +8.3,  +7.0,  +6.1,  +5.9
//   demo     1996           +6.0,  +6.6,  +5.8,  +5.5,  +5.3
//   demo     1996+none     +11.2,  +9.4,  +8.1,  +7.6,  +7.1
//   demo     bounded        -3.6,  -5.3,  -5.3,  -5.6,  -5.2
//   demo     bounded+none   +7.7,  +2.5,  -1.7,  -2.0,  -2.0
//   demo     exact          -5.2,  -5.0,  -4.8,  -5.3,  -4.7
//   demo     exact+none     +4.0,  -1.2,  -2.0,  -3.7,  -2.4
//   dm4      1991           -2.2,  -5.6,  -3.1,  -2.8,  -3.4
//   dm4      1991+none      +4.0,  +4.3,  +3.0,  +2.7,  +2.6
//   dm4      1994           -2.7,  -5.6,  -3.3,  -3.1,  -3.9
//   dm4      1994+none      +4.2,  +4.7,  +2.8,  +2.1,  +2.0
//   dm4      1996           +2.7,  -1.3,  +1.8,  +2.1,  +1.8
//   dm4      1996+none      +7.5,  +8.4,  +6.1,  +5.6,  +5.7
//   dm4      bounded        -0.8,  -3.2,  -2.2,  -3.4,  -2.8
//   dm4      bounded+none   +3.9,  +5.0,  +3.3,  +2.3,  +3.0
//   dm4      exact          -6.2,  -5.8,  -5.8,  -6.4,  -6.2
//   dm4      exact+none     +1.9,  -1.6,  -1.8,  -2.2,  -1.9
//   e1m7     1991           +1.8,  +3.0,  +3.0,  +3.6,  +2.8
//   e1m7     1991+none      +5.1,  +3.7,  +3.1,  +4.0,  +3.1
//   e1m7     1994           +2.5,  +3.4,  +3.2,  +3.5,  +3.0
//   e1m7     1994+none      +6.2,  +4.2,  +3.3,  +3.8,  +3.2
//   e1m7     1996           +4.0,  +4.2,  +3.4,  +3.3,  +2.8
//   e1m7     1996+none      +8.5,  +7.3,  +5.4,  +4.5,  +4.8
//   e1m7     bounded        +0.6,  -2.0,  -2.1,  -3.2,  -2.3
//   e1m7     bounded+none   +4.5,  -2.0,  -3.1,  -4.5,  -3.3
//   e1m7     exact          -3.2,  -3.9,  -5.6,  -7.5,  -6.1
//   e1m7     exact+none     +3.6,  -2.2,  -3.7,  -5.2,  -4.0
//   end      1991           -4.9,  -8.7,  -4.6,  -3.4,  -4.5
//   end      1991+none      +5.2,  +5.0,  +4.1,  +4.3,  +3.9
//   end      1994           -5.0,  -8.8,  -5.1,  -4.4,  -5.4
//   end      1994+none      +4.8,  +5.1,  +3.9,  +4.0,  +3.8
//   end      1996           +0.8,  -1.8,  +0.5,  +1.0,  +0.6
//   end      1996+none      +5.7,  +7.9,  +6.0,  +5.8,  +5.6
//   end      bounded        -2.6,  -4.9,  -2.7,  -3.4,  -3.0
//   end      bounded+none   +3.2,  +3.1,  +1.8,  -4.2,  -2.2
//   end      exact         -10.1,  -8.4,  -8.6,  -9.8,  -9.2
//   end      exact+none     +2.1,  -1.8,  -1.9,  -2.7,  -2.1
// presets, at most: 11.2, 9.4, 8.6, 9.8, 9.2
// any setting, at most: 12.2, 12.6, 13.8, 17.7, 14.0
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {4322, 7109, 31023, 18314, 11276}},
    {"vertices", {2558, 3324, 14339, 7772, 5112}},
    {"clipped corners", {6306, 12272, 50704, 31378, 19194}},
    {"stepped edge rows", {43, 62, 371, 198, 164}},
    {"spans", {478, 0, 2121, 1690, 1048}},
    {"surfaces", {43758, 78406, 290958, 158862, 105487}},
    {"mip spans", {885, 4119, 17025, 10916, 7109}},
    {"exact spans", {2382, 6187, 31618, 21663, 12057}},
    {"affine blocks", {553, 965, 4390, 2047, 1691}},
    {"even blocks", {762, 1422, 5735, 2827, 2162}},
    {"bounded blocks", {741, 1456, 6416, 3376, 2398}},
    {"texel-bounded blocks", {2023, 3940, 17559, 10563, 6844}},
    {"exact blocks", {762, 1106, 4275, 1988, 1581}},
    {"odd blocks", {418, 1009, 3919, 2319, 1530}},
    {"divisions", {240, 398, 2452, 1927, 1468}},
    {"table lookups", {384, 712, 2863, 1696, 1219}},
    {"Newton steps", {69, 139, 928, 930, 421}},
    {"second Newton steps", {100, 458, 2366, 2001, 1110}},
    {"textured pixels", {33, 62, 281, 98, 94}},
    {"divided pixels", {182, 524, 2722, 1995, 1068}},
    {"exact pixels", {136, 386, 1995, 1428, 778}},
    {"shared divisions", {454, 1334, 6942, 5075, 3289}},
    {"sky directions", {1893, 8940, 36128, 22004, 14871}},
    {"liquid pixels", {42, 99, 315, 142, 108}},
    {"translucent pixels", {286, 290, 970, 325, 309}},
    {"pixels of moving lights", {50, 82, 345, 191, 139}},
    {"fogged pixels", {766, 1855, 7693, 4580, 2994}},
    {"sprite pixels", {1555, 2959, 12446, 7091, 4536}},
    {"mirrored pixels", {413, 610, 2555, 1465, 940}},
    {"underwater pixels", {21, 47, 163, 83, 54}},
    {"particles", {10403, 18135, 90808, 61446, 35222}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 67, 241, 103, 91}},
    {"dithered texels", {74, 61, 283, 167, 93}},
}};

}  // namespace oblong
