#pragma once

#include <random>
#include <string>

#include "tests/map/map_source.h"

/// Sources as an editor leaves them: brushes turned to any angle, corners off the grid.
namespace oblong::test {

/// What follows a side's points.
inline constexpr std::string_view kStandardTail = "wall 0 0 0 1 1", kValveTail = "wall [ 1 0 0 0 ] [ 0 -1 0 0 ] 0 1 1";

/// Three directions at right angles, of length 1.
using Frame = std::array<Point, 3>;
Frame random_frame(std::mt19937& random);

/// A box around `centre`, `half` of its extents along the frame's directions, with points of six decimals.
struct TurnedBox {
    Point centre;
    std::array<double, 3> half;
    Frame frame;

    double volume() const { return 8 * half[0] * half[1] * half[2]; }
    std::string text(std::string_view tail = kStandardTail) const;
};

/// A room of six such boxes around the inside of `inside`: walls of 16 units that overlap nowhere.
std::string turned_room(const TurnedBox& inside);

/// From `low` up to `high`.
double random_between(std::mt19937& random, double low, double high);

}  // namespace oblong::test
