#pragma once

#include <array>
#include <string_view>

#include "engine/costs/costs.h"

namespace oblong {

struct EventPrice {
    std::string_view event;
    std::array<std::int32_t, kCurrencyCount> prices_10;  ///< tenths, in the order of Currency
};

// Prices and errors are written by `tests/operations/costs.py fit`. By how much the prices of some level's frames are
// off, the most by preset, in the order of Currency, per cent:
//   1991           7.6, 10.2,  6.1,  6.2,  6.1
//   1991+none      8.6,  6.6,  6.8,  6.5,  6.1
//   1994           6.8,  9.3,  6.1,  6.3,  6.0
//   1994+none     11.5,  9.4,  7.8,  6.9,  6.7
//   1996           6.5,  5.7,  4.8,  4.7,  4.6
//   1996+none     10.2,  8.5,  8.3,  9.0,  7.5
//   bounded        7.1,  8.1,  8.0,  8.6,  7.7
//   bounded+none   9.4,  5.2,  3.7,  4.0,  3.6
//   exact         10.1,  8.8,  8.1,  9.1,  8.7
//   exact+none     3.8,  2.2,  2.7,  4.1,  2.9
//   pixel          6.4,  6.2,  6.2,  6.5,  6.2
//   pixel+none    11.4,  9.3,  7.5,  6.8,  6.5
// presets, at most: 11.5, 10.2, 8.3, 9.1, 8.7
// any setting, at most: 12.1, 12.3, 11.2, 14.4, 11.0
inline constexpr std::array<EventPrice, kEventCount> kPrices{{
    {"nodes", {4948, 7258, 33205, 20312, 12398}},
    {"vertices", {1835, 2718, 12567, 7204, 4399}},
    {"clipped corners", {6896, 13641, 54565, 31985, 20047}},
    {"stepped edge rows", {175, 286, 887, 331, 289}},
    {"spans", {685, 168, 3190, 1994, 1293}},
    {"surfaces", {44507, 75696, 274621, 148324, 100374}},
    {"mip spans", {924, 4200, 17339, 11123, 7236}},
    {"exact spans", {2326, 6238, 32212, 22826, 12455}},
    {"affine blocks", {527, 946, 4725, 2685, 1979}},
    {"even blocks", {614, 1163, 5305, 2970, 2055}},
    {"bounded blocks", {671, 1353, 6194, 3460, 2379}},
    {"texel-bounded blocks", {1779, 3529, 16681, 10440, 6608}},
    {"exact blocks", {718, 1111, 4513, 2312, 1700}},
    {"odd blocks", {201, 694, 2253, 1366, 901}},
    {"block divisions", {488, 872, 4023, 2627, 2056}},
    {"table lookups", {595, 1116, 4513, 2793, 1879}},
    {"Newton steps", {93, 177, 1128, 1087, 503}},
    {"second Newton steps", {104, 468, 2403, 2060, 1143}},
    {"textured pixels", {32, 61, 276, 95, 92}},
    {"divided pixels", {184, 530, 2737, 2004, 1072}},
    {"exact pixels", {135, 384, 1978, 1412, 771}},
    {"shared divisions", {565, 1506, 7583, 5378, 3559}},
    {"sky directions", {2110, 9396, 37511, 22504, 15419}},
    {"liquid pixels", {37, 85, 269, 120, 93}},
    {"translucent pixels", {201, 170, 605, 190, 198}},
    {"pixels of moving lights", {189, 321, 1325, 748, 499}},
    {"fogged pixels", {751, 1809, 7534, 4507, 2944}},
    {"sprite pixels", {12, 52, 492, 0, 56}},
    {"mirrored pixels", {316, 507, 1857, 987, 638}},
    {"underwater pixels", {21, 47, 162, 82, 53}},
    {"particles", {17906, 32354, 149564, 96174, 56761}},
    {"lit texels", {74, 128, 448, 194, 167}},
    {"nearest lit texels", {44, 67, 241, 105, 91}},
    {"dithered texels", {75, 61, 283, 164, 93}},
    {"coloured texels", {474, 1039, 5499, 3983, 2225}},
}};

}  // namespace oblong
