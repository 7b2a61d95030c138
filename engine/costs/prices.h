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
//   demo     1991           -7.1,  -5.8,  -5.3,  -5.3,  -5.2
//   demo     1991+none      +7.2,  +5.7,  +5.7,  +5.6,  +5.4
//   demo     1994           -5.3,  -4.7,  -4.6,  -4.9,  -4.6
//   demo     1994+none     +11.8,  +9.7,  +8.1,  +7.1,  +6.9
//   demo     1996           -5.2,  -4.3,  -3.5,  -2.9,  -3.5
//   demo     1996+none     +10.3,  +8.5,  +8.3,  +8.9,  +7.4
//   demo     bounded        -5.8,  -6.7,  -6.8,  -7.5,  -6.7
//   demo     bounded+none   +9.5,  +5.2,  +3.6,  +1.9,  +2.6
//   demo     exact          -9.5,  -8.3,  -7.8,  -7.8,  -7.9
//   demo     exact+none     +3.2,  -2.1,  -2.8,  -4.4,  -2.8
//   demo     pixel          -5.1,  -4.8,  -4.9,  -5.4,  -5.1
//   demo     pixel+none    +11.4,  +9.1,  +7.4,  +6.3,  +6.0
//   dm4      1991           -1.4,  -5.4,  -2.6,  -2.3,  -2.8
//   dm4      1991+none      +4.8,  +5.1,  +4.2,  +3.6,  +3.5
//   dm4      1994           -1.4,  -4.8,  -2.8,  -2.6,  -3.2
//   dm4      1994+none      +4.9,  +5.1,  +3.2,  +2.5,  +2.4
//   dm4      1996           +1.0,  -1.9,  +0.8,  +1.5,  +0.7
//   dm4      1996+none      +6.1,  +6.6,  +5.4,  +5.6,  +5.0
//   dm4      bounded        +0.4,  -2.2,  -1.2,  -2.1,  -1.5
//   dm4      bounded+none   +4.9,  +5.1,  +3.5,  +2.8,  +3.5
//   dm4      exact          -5.9,  -5.6,  -5.6,  -6.2,  -6.0
//   dm4      exact+none     +1.8,  -1.6,  -1.6,  -1.8,  -1.7
//   dm4      pixel          +2.1,  -1.4,  +1.9,  +2.0,  +1.4
//   dm4      pixel+none     +7.3,  +8.9,  +6.9,  +6.2,  +6.0
//   e1m7     1991           -0.3,  +1.5,  +1.8,  +2.3,  +1.7
//   e1m7     1991+none      +4.2,  +3.0,  +2.9,  +3.7,  +2.7
//   e1m7     1994           +4.2,  +4.9,  +4.0,  +4.2,  +3.9
//   e1m7     1994+none      +7.5,  +5.4,  +4.0,  +4.6,  +4.0
//   e1m7     1996           +4.0,  +4.2,  +3.9,  +4.3,  +3.8
//   e1m7     1996+none      +8.4,  +6.7,  +5.6,  +5.2,  +5.1
//   e1m7     bounded        +3.8,  +1.5,  -1.3,  -3.0,  -1.6
//   e1m7     bounded+none   +7.5,  +4.2,  +2.9,  -4.0,  +2.6
//   e1m7     exact          -2.5,  -3.2,  -5.0,  -6.8,  -5.4
//   e1m7     exact+none     +3.4,  +1.9,  -3.1,  -4.5,  -3.4
//   e1m7     pixel          +4.3,  +4.9,  +3.6,  +3.0,  +3.1
//   e1m7     pixel+none     +8.5,  +6.5,  +5.1,  +4.4,  +4.5
//   end      1991           -5.4, -10.0,  -5.1,  -4.1,  -5.3
//   end      1991+none      +5.8,  +5.4,  +5.2,  +5.1,  +4.6
//   end      1994           -4.7,  -9.2,  -5.3,  -4.5,  -5.6
//   end      1994+none      +4.5,  +4.4,  +3.5,  +3.9,  +3.5
//   end      1996           -2.3,  -4.9,  -1.7,  +1.1,  -1.4
//   end      1996+none      +4.4,  +4.8,  +4.3,  +4.5,  +4.4
//   end      bounded        -2.1,  -4.6,  -2.4,  -3.0,  -2.6
//   end      bounded+none   +2.7,  +2.2,  -1.6,  -4.3,  -2.3
//   end      exact          -9.8,  -8.4,  -8.4,  -9.4,  -9.0
//   end      exact+none     +1.5,  -1.7,  -1.6,  -2.1,  -1.8
//   end      pixel          -1.7,  -3.9,  -1.2,  -1.1,  -1.5
//   end      pixel+none     +4.9,  +6.7,  +5.4,  +4.7,  +4.6
// presets, at most: 11.8, 10.0, 8.4, 9.4, 9.0
// any setting, at most: 11.9, 12.1, 11.7, 15.9, 12.1
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {5098, 7829, 35009, 21255, 12903}},
    {"vertices", {1912, 2768, 12602, 7272, 4450}},
    {"clipped corners", {6317, 13097, 51791, 30735, 19091}},
    {"stepped edge rows", {191, 345, 1276, 610, 457}},
    {"spans", {657, 155, 3103, 1994, 1273}},
    {"surfaces", {45546, 78939, 286245, 154427, 104105}},
    {"mip spans", {940, 4244, 17525, 11229, 7310}},
    {"exact spans", {2186, 6050, 31409, 22291, 12140}},
    {"affine blocks", {551, 978, 4874, 2749, 2024}},
    {"even blocks", {619, 1169, 5332, 2978, 2061}},
    {"bounded blocks", {677, 1357, 6208, 3456, 2376}},
    {"texel-bounded blocks", {1790, 3544, 16734, 10461, 6620}},
    {"exact blocks", {718, 1111, 4508, 2304, 1697}},
    {"odd blocks", {215, 705, 2393, 1430, 948}},
    {"divisions", {478, 852, 3932, 2557, 2016}},
    {"table lookups", {622, 1148, 4720, 2956, 1963}},
    {"Newton steps", {71, 150, 957, 949, 435}},
    {"second Newton steps", {103, 466, 2395, 2053, 1139}},
    {"textured pixels", {32, 61, 275, 94, 92}},
    {"divided pixels", {183, 529, 2734, 2003, 1072}},
    {"exact pixels", {135, 384, 1981, 1414, 772}},
    {"shared divisions", {559, 1501, 7564, 5367, 3550}},
    {"sky directions", {2075, 9346, 37213, 22363, 15360}},
    {"liquid pixels", {37, 87, 273, 123, 94}},
    {"translucent pixels", {207, 181, 662, 220, 218}},
    {"pixels of moving lights", {141, 240, 995, 567, 379}},
    {"fogged pixels", {726, 1763, 7334, 4384, 2858}},
    {"sprite pixels", {362, 745, 3373, 1759, 1162}},
    {"mirrored pixels", {304, 494, 1840, 1019, 644}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {15677, 28346, 133428, 87846, 51172}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 244, 106, 92}},
    {"dithered texels", {74, 60, 281, 164, 92}},
}};

}  // namespace oblong
