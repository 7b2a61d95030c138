#include "engine/surface/nearest_colour.h"

#include <limits>

#include "engine/base/table.h"

namespace oblong {

namespace {

int squared_distance(Rgb8 a, Rgb8 b) {
    const int red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return red * red + green * green + blue * blue;
}

}  // namespace

std::uint8_t nearest_colour(const Palette& palette, Rgb8 colour, ColourRange range) {
    int best = range.begin, best_distance = std::numeric_limits<int>::max();
    for (int index = range.begin; index < range.end; ++index) {
        const int distance = squared_distance(at(palette.colours, index), colour);
        if (distance >= best_distance) continue;
        best = index;
        best_distance = distance;
    }
    return static_cast<std::uint8_t>(best);
}

}  // namespace oblong
