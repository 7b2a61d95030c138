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
//   coloured 1991           -6.5,  -5.4,  -4.8,  -4.8,  -4.8
//   coloured 1991+none      +7.9,  +6.2,  +6.3,  +6.0,  +5.7
//   coloured 1994           -6.0,  -5.2,  -5.0,  -5.2,  -4.9
//   coloured 1994+none     +10.6,  +8.7,  +7.2,  +6.2,  +6.1
//   coloured 1996           -5.7,  -4.6,  -3.8,  -3.2,  -3.6
//   coloured 1996+none      +9.4,  +8.0,  +7.7,  +8.3,  +7.0
//   coloured bounded        -6.4,  -6.9,  -7.0,  -7.6,  -6.7
//   coloured bounded+none   +8.6,  +4.9,  +3.3,  +1.7,  +2.5
//   coloured exact          -9.6,  -7.9,  -7.2,  -7.2,  -7.3
//   coloured exact+none     +3.4,  -1.6,  -2.4,  -4.0,  -2.4
//   coloured pixel          -5.6,  -5.0,  -5.1,  -5.5,  -5.1
//   coloured pixel+none    +10.6,  +8.8,  +7.1,  +6.0,  +5.8
//   demo     1991           -6.5,  -5.4,  -4.8,  -4.8,  -4.7
//   demo     1991+none      +8.0,  +6.2,  +6.3,  +6.0,  +5.7
//   demo     1994           -5.9,  -5.2,  -5.0,  -5.2,  -4.9
//   demo     1994+none     +10.6,  +8.7,  +7.2,  +6.2,  +6.2
//   demo     1996           -5.6,  -4.5,  -3.8,  -3.1,  -3.6
//   demo     1996+none      +9.5,  +8.1,  +7.7,  +8.3,  +7.0
//   demo     bounded        -6.4,  -6.9,  -7.0,  -7.6,  -6.7
//   demo     bounded+none   +8.7,  +4.9,  +3.3,  +1.7,  +2.5
//   demo     exact          -9.5,  -7.8,  -7.2,  -7.1,  -7.2
//   demo     exact+none     +3.5,  -1.6,  -2.4,  -4.0,  -2.4
//   demo     pixel          -5.5,  -5.0,  -5.0,  -5.5,  -5.1
//   demo     pixel+none    +10.6,  +8.8,  +7.1,  +6.0,  +5.8
//   dm4      1991           -1.2,  -5.0,  -2.5,  -2.0,  -2.3
//   dm4      1991+none      +6.2,  +6.4,  +5.1,  +4.5,  +4.0
//   dm4      1994           -1.0,  -4.3,  -2.6,  -2.3,  -2.9
//   dm4      1994+none      +5.3,  +5.5,  +3.6,  +2.8,  +2.6
//   dm4      1996           +1.8,  -1.5,  +1.4,  +2.0,  +1.2
//   dm4      1996+none      +6.7,  +7.4,  +6.0,  +6.0,  +5.5
//   dm4      bounded        +0.9,  -1.3,  -0.3,  -1.2,  -0.7
//   dm4      bounded+none   +5.2,  +5.5,  +3.9,  +3.2,  +3.8
//   dm4      exact          -5.3,  -4.9,  -4.9,  -5.5,  -5.3
//   dm4      exact+none     +2.0,  +1.4,  +1.1,  -1.1,  -1.0
//   dm4      pixel          +2.9,  +1.5,  +2.9,  +2.9,  +2.3
//   dm4      pixel+none     +7.8,  +9.8,  +7.8,  +7.1,  +6.9
//   e1m7     1991           +1.6,  +2.1,  +2.5,  +3.1,  +2.4
//   e1m7     1991+none      +5.3,  +4.1,  +3.6,  +3.7,  +2.7
//   e1m7     1994           +4.6,  +5.2,  +4.2,  +4.3,  +4.0
//   e1m7     1994+none      +7.4,  +5.5,  +3.9,  +4.2,  +3.6
//   e1m7     1996           +4.9,  +4.7,  +4.2,  +4.4,  +4.0
//   e1m7     1996+none      +8.6,  +7.2,  +5.9,  +5.5,  +5.5
//   e1m7     bounded        +4.6,  +2.7,  +1.7,  -2.6,  +1.4
//   e1m7     bounded+none   +7.6,  +4.8,  +3.5,  -4.0,  +3.2
//   e1m7     exact          +2.3,  -2.4,  -4.2,  -6.1,  -4.7
//   e1m7     exact+none     +3.5,  +2.3,  -2.5,  -3.9,  -2.7
//   e1m7     pixel          +5.2,  +5.5,  +4.2,  +3.5,  +3.6
//   e1m7     pixel+none     +8.7,  +7.1,  +5.8,  +5.0,  +5.1
//   end      1991           -4.9,  -9.8,  -5.1,  -4.0,  -5.6
//   end      1991+none      +5.8,  +5.5,  +5.3,  +5.5,  +4.7
//   end      1994           -4.6,  -9.1,  -5.3,  -4.5,  -5.6
//   end      1994+none      +4.5,  +4.5,  +3.6,  +3.9,  +3.4
//   end      1996           -2.0,  -4.4,  -1.4,  +1.1,  -1.1
//   end      1996+none      +4.5,  +5.3,  +4.7,  +4.7,  +4.7
//   end      bounded        -1.9,  -4.0,  -1.8,  -2.4,  -2.0
//   end      bounded+none   +2.7,  +2.7,  +1.8,  -3.7,  -1.7
//   end      exact          -9.3,  -7.8,  -7.8,  -8.8,  -8.4
//   end      exact+none     +1.7,  -1.1,  -0.9,  -1.4,  -1.1
//   end      pixel          -1.4,  -3.3,  -0.6,  -0.7,  -0.9
//   end      pixel+none     +5.2,  +7.4,  +6.2,  +5.3,  +5.2
// presets, at most: 10.6, 9.8, 7.8, 8.8, 8.4
// any setting, at most: 21.8, 20.0, 16.9, 14.6, 15.8
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {4773, 7109, 32153, 19518, 11954}},
    {"vertices", {1739, 2565, 11898, 6857, 4124}},
    {"clipped corners", {7136, 13845, 55793, 32671, 20554}},
    {"stepped edge rows", {180, 289, 902, 343, 296}},
    {"spans", {726, 239, 3502, 2182, 1418}},
    {"surfaces", {43517, 74246, 267767, 144222, 97752}},
    {"mip spans", {928, 4215, 17455, 11208, 7286}},
    {"exact spans", {2325, 6251, 32200, 22724, 12450}},
    {"affine blocks", {527, 934, 4715, 2708, 1978}},
    {"even blocks", {617, 1169, 5316, 2967, 2057}},
    {"bounded blocks", {673, 1365, 6256, 3494, 2399}},
    {"texel-bounded blocks", {1775, 3525, 16676, 10438, 6599}},
    {"exact blocks", {710, 1093, 4439, 2266, 1670}},
    {"odd blocks", {237, 760, 2550, 1519, 1015}},
    {"block divisions", {489, 869, 4032, 2644, 2072}},
    {"table lookups", {616, 1139, 4617, 2849, 1925}},
    {"Newton steps", {95, 185, 1165, 1110, 520}},
    {"second Newton steps", {101, 474, 2437, 2088, 1159}},
    {"textured pixels", {32, 61, 274, 93, 91}},
    {"divided pixels", {185, 533, 2750, 2014, 1077}},
    {"exact pixels", {135, 385, 1989, 1422, 775}},
    {"shared divisions", {567, 1516, 7632, 5409, 3578}},
    {"sky directions", {2308, 9685, 38483, 22922, 15706}},
    {"liquid pixels", {35, 83, 259, 115, 89}},
    {"translucent pixels", {187, 154, 564, 180, 190}},
    {"pixels of moving lights", {189, 318, 1319, 727, 490}},
    {"fogged pixels", {805, 1939, 8073, 4836, 3152}},
    {"sprite pixels", {0, 0, 114, 0, 0}},
    {"mirrored pixels", {280, 451, 1611, 816, 527}},
    {"underwater pixels", {21, 47, 160, 81, 52}},
    {"particles", {17697, 32075, 148712, 95682, 56488}},
    {"lit texels", {74, 128, 448, 194, 167}},
    {"nearest lit texels", {44, 67, 240, 104, 90}},
    {"dithered texels", {76, 60, 282, 165, 93}},
    {"coloured texels", {456, 961, 5081, 3695, 2052}},
}};

}  // namespace oblong
