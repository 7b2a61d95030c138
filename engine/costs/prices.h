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
//   demo     1991           -7.0,  -5.8,  -5.2,  -5.2,  -5.2
//   demo     1991+none      +8.7,  +6.9,  +7.0,  +6.6,  +6.2
//   demo     1994           -6.2,  -5.5,  -5.3,  -5.5,  -5.3
//   demo     1994+none     +11.7,  +9.5,  +7.9,  +6.9,  +6.7
//   demo     1996           -5.9,  -5.0,  -4.1,  -3.4,  -3.9
//   demo     1996+none     +10.4,  +8.5,  +8.3,  +8.9,  +7.4
//   demo     bounded        -6.7,  -7.4,  -7.4,  -8.0,  -7.2
//   demo     bounded+none   +9.5,  +5.2,  +3.6,  +2.0,  +2.7
//   demo     exact          -9.7,  -8.2,  -7.6,  -7.5,  -7.6
//   demo     exact+none     +3.5,  -1.9,  -2.6,  -4.3,  -2.7
//   demo     pixel          -5.9,  -5.5,  -5.5,  -5.8,  -5.6
//   demo     pixel+none    +11.5,  +9.1,  +7.4,  +6.4,  +6.1
//   dm4      1991           -1.9,  -5.5,  -2.8,  -2.4,  -3.0
//   dm4      1991+none      +5.2,  +5.4,  +4.3,  +3.6,  +3.2
//   dm4      1994           -1.5,  -5.0,  -2.8,  -2.8,  -3.4
//   dm4      1994+none      +4.7,  +4.7,  +3.0,  +2.2,  +2.1
//   dm4      1996           +1.2,  -1.9,  +0.9,  +1.7,  +0.8
//   dm4      1996+none      +6.2,  +6.6,  +5.5,  +5.7,  +5.1
//   dm4      bounded        +0.3,  -2.3,  -1.1,  -2.0,  -1.4
//   dm4      bounded+none   +4.7,  +4.9,  +3.5,  +2.8,  +3.4
//   dm4      exact          -5.9,  -5.5,  -5.5,  -6.1,  -5.9
//   dm4      exact+none     +1.7,  -1.5,  -1.5,  -1.8,  -1.6
//   dm4      pixel          +2.2,  -1.4,  +2.0,  +2.1,  +1.5
//   dm4      pixel+none     +7.2,  +8.8,  +7.0,  +6.2,  +6.0
//   e1m7     1991           +0.4,  +1.6,  +2.0,  +2.5,  +2.0
//   e1m7     1991+none      +4.9,  +3.6,  +3.2,  +3.6,  +2.6
//   e1m7     1994           +4.2,  +4.9,  +4.1,  +4.1,  +3.8
//   e1m7     1994+none      +7.4,  +5.2,  +3.9,  +4.4,  +3.8
//   e1m7     1996           +4.3,  +4.4,  +4.1,  +4.5,  +4.0
//   e1m7     1996+none      +8.6,  +6.8,  +5.7,  +5.4,  +5.3
//   e1m7     bounded        +3.9,  +1.6,  -1.1,  -2.9,  -1.5
//   e1m7     bounded+none   +7.5,  +4.2,  +3.0,  -4.0,  +2.7
//   e1m7     exact          -2.3,  -3.1,  -4.8,  -6.7,  -5.2
//   e1m7     exact+none     +3.3,  +1.9,  -3.0,  -4.4,  -3.2
//   e1m7     pixel          +4.5,  +5.1,  +3.8,  +3.2,  +3.3
//   e1m7     pixel+none     +8.6,  +6.5,  +5.3,  +4.6,  +4.6
//   end      1991           -5.5, -10.4,  -5.5,  -4.5,  -6.0
//   end      1991+none      +5.3,  +4.9,  +4.7,  +4.7,  +4.3
//   end      1994           -4.9,  -9.5,  -5.5,  -4.8,  -5.8
//   end      1994+none      +4.2,  +4.1,  +3.3,  +3.5,  +3.2
//   end      1996           -2.3,  -4.9,  -1.6,  +1.1,  -1.3
//   end      1996+none      +4.4,  +4.7,  +4.4,  +4.5,  +4.4
//   end      bounded        -2.2,  -4.8,  -2.4,  -3.0,  -2.6
//   end      bounded+none   +2.6,  +2.1,  -1.6,  -4.3,  -2.3
//   end      exact          -9.8,  -8.3,  -8.3,  -9.4,  -8.9
//   end      exact+none     +1.5,  -1.7,  -1.5,  -2.0,  -1.6
//   end      pixel          -1.8,  -4.0,  -1.1,  -1.1,  -1.5
//   end      pixel+none     +4.8,  +6.5,  +5.5,  +4.7,  +4.6
// presets, at most: 11.7, 10.4, 8.3, 9.4, 8.9
// any setting, at most: 12.0, 12.3, 11.1, 14.9, 11.3
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {5077, 7721, 34501, 20992, 12750}},
    {"vertices", {1909, 2792, 12739, 7364, 4487}},
    {"clipped corners", {6452, 13323, 52969, 31295, 19452}},
    {"stepped edge rows", {181, 294, 932, 356, 306}},
    {"spans", {666, 157, 3120, 1981, 1273}},
    {"surfaces", {45591, 78461, 284475, 153488, 103585}},
    {"mip spans", {935, 4227, 17450, 11180, 7277}},
    {"exact spans", {2246, 6130, 31770, 22521, 12277}},
    {"affine blocks", {538, 950, 4735, 2693, 1982}},
    {"even blocks", {616, 1165, 5314, 2976, 2058}},
    {"bounded blocks", {671, 1349, 6185, 3457, 2374}},
    {"texel-bounded blocks", {1785, 3542, 16727, 10466, 6624}},
    {"exact blocks", {719, 1113, 4519, 2316, 1702}},
    {"odd blocks", {200, 689, 2281, 1373, 908}},
    {"divisions", {483, 860, 3976, 2597, 2037}},
    {"table lookups", {601, 1121, 4549, 2819, 1894}},
    {"Newton steps", {88, 171, 1094, 1061, 490}},
    {"second Newton steps", {104, 468, 2409, 2065, 1145}},
    {"textured pixels", {32, 61, 276, 94, 92}},
    {"divided pixels", {184, 531, 2740, 2005, 1073}},
    {"exact pixels", {135, 384, 1981, 1413, 772}},
    {"shared divisions", {557, 1500, 7559, 5363, 3547}},
    {"sky directions", {2136, 9472, 37731, 22538, 15463}},
    {"liquid pixels", {37, 86, 273, 122, 94}},
    {"translucent pixels", {204, 175, 640, 212, 212}},
    {"pixels of moving lights", {167, 283, 1169, 662, 442}},
    {"fogged pixels", {795, 1931, 8031, 4806, 3134}},
    {"sprite pixels", {292, 571, 2600, 1220, 848}},
    {"mirrored pixels", {326, 517, 1899, 1014, 656}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {17721, 31745, 146933, 94658, 55834}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 243, 105, 91}},
    {"dithered texels", {74, 60, 281, 164, 92}},
}};

}  // namespace oblong
