#pragma once

#include <array>
#include <string_view>

#include "tools/measure/costs.h"

namespace oblong {

struct EventPrice {
    std::string_view event;
    std::array<double, kCurrencyCount> prices;  ///< in the order of Currency
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
    {"nodes", {432.2, 710.9, 3102.3, 1831.4, 1127.6}},
    {"vertices", {255.8, 332.4, 1433.9, 777.2, 511.2}},
    {"clipped corners", {630.6, 1227.2, 5070.4, 3137.8, 1919.4}},
    {"stepped edge rows", {4.3, 6.2, 37.1, 19.8, 16.4}},
    {"spans", {47.8, 0.0, 212.1, 169.0, 104.8}},
    {"surfaces", {4375.8, 7840.6, 29095.8, 15886.2, 10548.7}},
    {"mip spans", {88.5, 411.9, 1702.5, 1091.6, 710.9}},
    {"exact spans", {238.2, 618.7, 3161.8, 2166.3, 1205.7}},
    {"affine blocks", {55.3, 96.5, 439.0, 204.7, 169.1}},
    {"even blocks", {76.2, 142.2, 573.5, 282.7, 216.2}},
    {"bounded blocks", {74.1, 145.6, 641.6, 337.6, 239.8}},
    {"texel-bounded blocks", {202.3, 394.0, 1755.9, 1056.3, 684.4}},
    {"exact blocks", {76.2, 110.6, 427.5, 198.8, 158.1}},
    {"odd blocks", {41.8, 100.9, 391.9, 231.9, 153.0}},
    {"divisions", {24.0, 39.8, 245.2, 192.7, 146.8}},
    {"table lookups", {38.4, 71.2, 286.3, 169.6, 121.9}},
    {"Newton steps", {6.9, 13.9, 92.8, 93.0, 42.1}},
    {"second Newton steps", {10.0, 45.8, 236.6, 200.1, 111.0}},
    {"textured pixels", {3.3, 6.2, 28.1, 9.8, 9.4}},
    {"divided pixels", {18.2, 52.4, 272.2, 199.5, 106.8}},
    {"exact pixels", {13.6, 38.6, 199.5, 142.8, 77.8}},
    {"shared divisions", {45.4, 133.4, 694.2, 507.5, 328.9}},
    {"sky directions", {189.3, 894.0, 3612.8, 2200.4, 1487.1}},
    {"liquid pixels", {4.2, 9.9, 31.5, 14.2, 10.8}},
    {"translucent pixels", {28.6, 29.0, 97.0, 32.5, 30.9}},
    {"pixels of moving lights", {5.0, 8.2, 34.5, 19.1, 13.9}},
    {"fogged pixels", {76.6, 185.5, 769.3, 458.0, 299.4}},
    {"sprite pixels", {155.5, 295.9, 1244.6, 709.1, 453.6}},
    {"mirrored pixels", {41.3, 61.0, 255.5, 146.5, 94.0}},
    {"underwater pixels", {2.1, 4.7, 16.3, 8.3, 5.4}},
    {"particles", {1040.3, 1813.5, 9080.8, 6144.6, 3522.2}},
    {"lit texels", {7.4, 12.8, 44.9, 19.4, 16.7}},
    {"nearest lit texels", {4.4, 6.7, 24.1, 10.3, 9.1}},
    {"dithered texels", {7.4, 6.1, 28.3, 16.7, 9.3}},
}};

}  // namespace oblong
