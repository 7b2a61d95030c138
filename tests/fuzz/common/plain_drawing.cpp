#include "tests/fuzz/common/plain_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblong::fuzz {
namespace {

__extension__ using Wide = __int128;

std::int64_t floor_quotient(Wide above, Wide below) {
    const Wide quotient = above / below;
    return static_cast<std::int64_t>(quotient - (above % below < 0 ? 1 : 0));
}

std::int64_t difference(std::int32_t a, std::int32_t b) {
    return std::int64_t{a} - b;
}

// Of the edge from a to b: above 0 on its right, y down.
std::int64_t edge_at(PixelPosition a, PixelPosition b, PixelPosition pixel) {
    return difference(b.column, a.column) * difference(pixel.row, a.row) -
           difference(b.row, a.row) * difference(pixel.column, a.column);
}

}  // namespace

bool PlainRectangle::has(std::int64_t column, std::int64_t row) const {
    return column >= x && column < x + width && row >= y && row < y + height;
}

bool PlainRectangle::has_on_border(std::int64_t column, std::int64_t row) const {
    return has(column, row) && (column == x || row == y || column == x + width - 1 || row == y + height - 1);
}

bool is_on_line(PixelPosition from, PixelPosition to, PixelPosition pixel) {
    const std::int64_t across = difference(to.column, from.column), down = difference(to.row, from.row);
    if (std::abs(down) > std::abs(across)) {
        const auto swapped = [](PixelPosition at) { return PixelPosition{at.row, at.column}; };
        return is_on_line(swapped(from), swapped(to), swapped(pixel));
    }
    if (across < 0) return is_on_line(to, from, pixel);
    if (pixel.column < from.column || pixel.column > to.column) return false;
    if (across == 0) return pixel.row == from.row;
    const Wide rise = Wide{2} * difference(pixel.column, from.column) * down + across;
    return pixel.row == from.row + floor_quotient(rise, Wide{2} * across);
}

bool is_in_circle(const ScreenMode& mode, PixelPosition middle, std::int32_t radius_px, PixelPosition pixel) {
    const Wide wide = Wide{mode.display.numerator} * mode.height_px,
               high = Wide{mode.display.denominator} * mode.width_px;
    const Wide across = 2 * wide * difference(pixel.column, middle.column),
               down = 2 * high * difference(pixel.row, middle.row), radius = wide * (2 * Wide{radius_px} + 1);
    return across * across + down * down <= radius * radius;
}

bool is_in_triangle(std::array<PixelPosition, 3> corners, PixelPosition pixel) {
    const std::int64_t area = edge_at(corners[0], corners[1], corners[2]);
    if (area < 0) std::swap(corners[1], corners[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const PixelPosition a = corners[i], b = corners[(i + 1) % 3];
        const std::int64_t at = edge_at(a, b, pixel);
        const bool owns = b.row < a.row || (b.row == a.row && b.column > a.column);
        if (at < 0 || (at == 0 && !owns)) return false;
    }
    return area != 0;
}

int turned_texel(const Picture& picture, PixelPosition middle, std::int32_t degrees_256, std::int32_t scale_256,
                 PixelPosition pixel) {
    const double turn = degrees_256 * std::numbers::pi / (180 * 256), scale = scale_256 / 256.0;
    const auto right = static_cast<double>(difference(pixel.column, middle.column)),
               down = static_cast<double>(difference(pixel.row, middle.row));
    const double u = (right * std::cos(turn) - down * std::sin(turn)) / scale + picture.width_px / 2.0,
                 v = (right * std::sin(turn) + down * std::cos(turn)) / scale + picture.height_px / 2.0;
    // Angles have 16 bits, sines 16 fraction bits, and their quotients, too.
    const double error = (std::abs(right) + std::abs(down)) * (6e-5 / scale + 2e-5) + 1e-6;
    const auto is_near_border = [&](double at) { return std::abs(at - std::round(at)) <= error; };
    if (u < -error || v < -error || u > picture.width_px + error || v > picture.height_px + error) return kNone;
    if (is_near_border(u) || is_near_border(v) || error >= 0.5) return kUnknown;
    const auto texel = static_cast<std::size_t>(v) * as_size(picture.width_px) + static_cast<std::size_t>(u);
    return picture.pixels[texel];
}

}  // namespace oblong::fuzz
