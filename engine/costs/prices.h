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
//   demo     1991           -6.7,  -5.6,  -5.0,  -5.0,  -5.0
//   demo     1991+none      +8.5,  +6.8,  +6.9,  +6.6,  +6.1
//   demo     1994           -6.0,  -5.3,  -5.1,  -5.2,  -5.0
//   demo     1994+none     +11.4,  +9.5,  +7.9,  +7.0,  +6.7
//   demo     1996           -5.7,  -4.7,  -3.9,  -3.1,  -3.7
//   demo     1996+none     +10.2,  +8.6,  +8.3,  +9.0,  +7.4
//   demo     bounded        -6.5,  -7.2,  -7.2,  -7.8,  -7.0
//   demo     bounded+none   +9.2,  +5.2,  +3.6,  +2.0,  +2.7
//   demo     exact          -9.7,  -8.2,  -7.5,  -7.4,  -7.6
//   demo     exact+none     +3.2,  -1.9,  -2.7,  -4.3,  -2.7
//   demo     pixel          -5.7,  -5.2,  -5.3,  -5.6,  -5.4
//   demo     pixel+none    +11.2,  +9.2,  +7.5,  +6.5,  +6.1
//   dm4      1991           -2.0,  -5.9,  -3.0,  -2.4,  -3.2
//   dm4      1991+none      +5.2,  +5.7,  +4.5,  +4.1,  +3.4
//   dm4      1994           -1.6,  -5.3,  -3.0,  -2.7,  -3.5
//   dm4      1994+none      +4.6,  +5.0,  +3.2,  +2.6,  +2.3
//   dm4      1996           +1.0,  -2.2,  +0.8,  +1.7,  +0.6
//   dm4      1996+none      +6.1,  +6.8,  +5.7,  +6.0,  +5.2
//   dm4      bounded        -0.2,  -2.5,  -1.2,  -1.9,  -1.5
//   dm4      bounded+none   +4.5,  +4.9,  +3.5,  +3.0,  +3.5
//   dm4      exact          -5.9,  -5.5,  -5.5,  -6.1,  -5.9
//   dm4      exact+none     +1.7,  -1.5,  -1.5,  -1.7,  -1.6
//   dm4      pixel          +2.0,  -1.7,  +2.0,  +2.2,  +1.4
//   dm4      pixel+none     +7.1,  +9.0,  +7.1,  +6.6,  +6.2
//   e1m7     1991           +0.4,  +1.7,  +2.2,  +2.9,  +2.1
//   e1m7     1991+none      +4.7,  +4.0,  +3.5,  +3.9,  +2.8
//   e1m7     1994           +4.4,  +5.0,  +4.2,  +4.4,  +3.9
//   e1m7     1994+none      +7.1,  +5.6,  +4.0,  +4.7,  +3.9
//   e1m7     1996           +4.2,  +4.5,  +4.2,  +4.7,  +4.0
//   e1m7     1996+none      +8.3,  +7.1,  +5.9,  +5.7,  +5.4
//   e1m7     bounded        +3.8,  +1.8,  -1.1,  -2.7,  -1.4
//   e1m7     bounded+none   +7.3,  +4.5,  +3.2,  -3.8,  +2.9
//   e1m7     exact          -2.4,  -3.0,  -4.8,  -6.6,  -5.2
//   e1m7     exact+none     +3.3,  +2.0,  -2.9,  -4.3,  -3.1
//   e1m7     pixel          +4.4,  +5.2,  +3.9,  +3.5,  +3.4
//   e1m7     pixel+none     +8.3,  +6.8,  +5.5,  +4.9,  +4.8
//   end      1991           -5.5, -10.7,  -5.6,  -4.5,  -6.2
//   end      1991+none      +5.0,  +5.0,  +4.8,  +5.0,  +4.4
//   end      1994           -5.0,  -9.8,  -5.6,  -4.7,  -6.0
//   end      1994+none      +4.0,  +4.2,  +3.4,  +3.9,  +3.3
//   end      1996           -2.4,  -5.1,  -1.7,  +1.2,  -1.5
//   end      1996+none      +4.1,  +4.9,  +4.5,  +4.8,  +4.5
//   end      bounded        -2.3,  -5.0,  -2.4,  -2.9,  -2.6
//   end      bounded+none   +2.2,  +2.2,  -1.6,  -4.1,  -2.2
//   end      exact          -9.6,  -8.3,  -8.3,  -9.3,  -8.9
//   end      exact+none     +1.3,  -1.7,  -1.5,  -2.0,  -1.6
//   end      pixel          -1.9,  -4.2,  -1.2,  -1.1,  -1.6
//   end      pixel+none     +4.6,  +6.8,  +5.6,  +5.0,  +4.7
// presets, at most: 11.4, 10.7, 8.3, 9.3, 8.9
// any setting, at most: 12.1, 12.9, 11.1, 14.8, 11.2
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {4956, 7362, 33294, 20343, 12383}},
    {"vertices", {1869, 2819, 12886, 7406, 4517}},
    {"clipped corners", {6560, 13166, 52744, 31135, 19445}},
    {"stepped edge rows", {179, 289, 904, 339, 295}},
    {"spans", {671, 144, 3090, 1955, 1259}},
    {"surfaces", {44864, 76439, 277278, 149432, 101255}},
    {"mip spans", {935, 4228, 17442, 11178, 7277}},
    {"exact spans", {2286, 6147, 31815, 22552, 12298}},
    {"affine blocks", {532, 944, 4730, 2699, 1983}},
    {"even blocks", {616, 1165, 5313, 2976, 2058}},
    {"bounded blocks", {671, 1350, 6184, 3459, 2377}},
    {"texel-bounded blocks", {1787, 3545, 16741, 10476, 6630}},
    {"exact blocks", {719, 1113, 4522, 2318, 1704}},
    {"odd blocks", {205, 697, 2270, 1373, 909}},
    {"block divisions", {481, 852, 3948, 2583, 2027}},
    {"table lookups", {595, 1114, 4510, 2792, 1879}},
    {"Newton steps", {92, 176, 1122, 1083, 501}},
    {"second Newton steps", {104, 468, 2404, 2061, 1143}},
    {"textured pixels", {32, 61, 276, 95, 92}},
    {"divided pixels", {185, 531, 2740, 2005, 1073}},
    {"exact pixels", {135, 384, 1980, 1413, 772}},
    {"shared divisions", {561, 1498, 7552, 5360, 3545}},
    {"sky directions", {2126, 9398, 37483, 22405, 15364}},
    {"liquid pixels", {37, 87, 276, 124, 96}},
    {"translucent pixels", {199, 162, 597, 190, 198}},
    {"pixels of moving lights", {184, 313, 1292, 732, 487}},
    {"fogged pixels", {808, 1944, 8092, 4844, 3158}},
    {"sprite pixels", {120, 245, 1269, 411, 342}},
    {"mirrored pixels", {309, 503, 1853, 994, 637}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {17787, 31971, 147941, 95195, 56197}},
    {"lit texels", {74, 128, 449, 194, 167}},
    {"nearest lit texels", {44, 68, 243, 105, 91}},
    {"dithered texels", {74, 60, 281, 164, 92}},
    {"coloured texels", {460, 600, 2500, 1500, 900}},
}};

}  // namespace oblong
