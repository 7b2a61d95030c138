#include "tests/map/mapper_source.h"

#include <cstdio>

namespace oblong::test {

using map::cross;
using map::dot;
using map::length;
using map::scaled;

namespace {

std::string side_text(const std::array<Point, 3>& points, std::string_view tail) {
    std::string text;
    for (const Point& point : points) {
        char numbers[96];
        std::snprintf(numbers, sizeof numbers, "( %.6f %.6f %.6f ) ", point.x, point.y, point.z);
        text += numbers;
    }
    return text + std::string(tail) + "\n";
}

Point random_point(std::mt19937& random) {
    return {random_between(random, -1, 1), random_between(random, -1, 1), random_between(random, -1, 1)};
}

Point unit(const Point& vector) {
    return scaled(vector, 1 / length(vector));
}

}  // namespace

double random_between(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

Frame random_frame(std::mt19937& random) {
    const Point first = unit(random_point(random) + Point{0, 0, 2});
    const Point second = unit(cross(first, random_point(random) + Point{0, 2, 0}));
    return {first, second, cross(first, second)};
}

std::string TurnedBox::text(std::string_view tail) const {
    std::string sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Point u = scaled(frame[(axis + 1) % 3], 50), v = scaled(frame[(axis + 2) % 3], 50);
        for (const double sign : {1.0, -1.0}) {
            const Point at = centre + scaled(frame[axis], sign * half[axis]);
            sides += sign > 0 ? side_text({at, at + v, at + u}, tail) : side_text({at, at + u, at + v}, tail);
        }
    }
    return "{\n" + sides + "}\n";
}

std::string turned_room(const TurnedBox& inside) {
    constexpr double kHalfWall = 8;
    std::string walls;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            TurnedBox wall = inside;
            wall.centre = inside.centre + scaled(inside.frame[axis], sign * (inside.half[axis] + kHalfWall));
            wall.half[axis] = kHalfWall;
            for (std::size_t wider = 0; wider < axis; ++wider) wall.half[wider] += 2 * kHalfWall;
            walls += wall.text();
        }
    }
    return walls;
}

}  // namespace oblong::test
