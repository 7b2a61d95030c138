#include "tools/map/source/textures.h"

#include <numbers>

#include "tools/map/source/contents.h"

namespace oblong::map {
namespace {

// Standard maps lay a texture along the two axes of the coordinate plane that the side faces most; of equals, the
// floor wins over walls facing x, these over walls facing y. Rows of a texture run down.
std::array<Point, 2> standard_axes(const Point& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    if (z >= x && z >= y) return {Point{1, 0, 0}, Point{0, -1, 0}};
    if (x >= y) return {Point{0, 1, 0}, Point{0, 0, -1}};
    return {Point{1, 0, 0}, Point{0, 0, -1}};
}

struct Turn {
    double cosine = 1, sine = 0;
};

// Quarter turns come out exact.
Turn turn_of(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters)) {
        const int quarter = static_cast<int>(quarters) & 3;
        return {quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0, quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0};
    }
    const double radians = degrees * std::numbers::pi / 180;
    return {std::cos(radians), std::sin(radians)};
}

// The rotation turns the axes in the plane of the two world axes that carry them (x before y before z, except that
// u's comes first).
std::array<Point, 2> rotated(const std::array<Point, 2>& axes, double degrees) {
    const Turn turn = turn_of(degrees);
    const auto carrier = [](const Point& axis) { return axis.x != 0 ? 0 : axis.y != 0 ? 1 : 2; };
    const int first = carrier(axes[0]), second = carrier(axes[1]);
    std::array<Point, 2> result = axes;
    for (Point& axis : result) {
        const double u = component(axis, first), v = component(axis, second);
        component(axis, first) = turn.cosine * u - turn.sine * v;
        component(axis, second) = turn.sine * u + turn.cosine * v;
    }
    return result;
}

}  // namespace

int TextureList::find_or_add(const MapSide& side, const Point& normal) {
    const TextureFields& fields = side.texture;
    if (is_undrawn_texture(fields.name)) return -1;
    TexInfo wanted;
    wanted.axes = fields.has_axes ? fields.axes : rotated(standard_axes(normal), fields.rotation_degrees);
    for (std::size_t i = 0; i < 2; ++i) wanted.axes[i] = scaled(wanted.axes[i], 1 / fields.scale[i]);
    wanted.offset = fields.offset;
    wanted.texture = find_or_add_name({fields.name, side.line});
    wanted.is_special = contents_of_texture(fields.name) != contents::kSolid;
    for (std::size_t i = 0; i < texinfos_.size(); ++i) {
        if (texinfos_[i] == wanted) return static_cast<int>(i);
    }
    texinfos_.push_back(wanted);
    return static_cast<int>(texinfos_.size()) - 1;
}

int TextureList::find_or_add_name(const TextureUse& use) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i].name == use.name) return static_cast<int>(i);
    }
    names_.push_back(use);
    return static_cast<int>(names_.size()) - 1;
}

}  // namespace oblong::map
