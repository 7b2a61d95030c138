#include "tools/reference/rays.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace oblong::reference {

namespace {

constexpr int kGridBits = 20;
constexpr double kLargest = 34359738368.0;  ///< 2^35: determinants fit 128 bits

std::int64_t rounded(double value) {
    if (!(std::abs(value) < kLargest)) throw std::range_error("a corner beyond 2^35 units times pixels from the eye");
    return std::llround(std::ldexp(value, kGridBits));
}

/// Floor; the divisor is above 0.
Wide floor_quotient(Wide dividend, Wide divisor) {
    return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
}

int clamped(Wide column, int width_px) {
    return static_cast<int>(std::clamp<Wide>(column, 0, width_px));
}

/// The sign of x a + y b + z c. The left factors have up to 111 bits: so their halves are multiplied separately.
int sign_of_sum(Wide x, Wide y, Wide z, const RayCorner& c) {
    constexpr int kLowBits = 48;
    const auto high = [](Wide value) { return value >> kLowBits; };
    const auto low = [&](Wide value) { return value - (high(value) << kLowBits); };
    const Wide low_sum = low(x) * c.x + low(y) * c.y + low(z) * c.z;
    const Wide high_sum = high(x) * c.x + high(y) * c.y + high(z) * c.z + high(low_sum);
    if (high_sum != 0) return high_sum > 0 ? 1 : -1;
    return low(low_sum) > 0 ? 1 : 0;
}

}  // namespace

RayCorner make_ray_corner(const Vec& world_point, const Camera& camera) {
    const Vec view = to_view(world_point, camera.eye, camera.axes);
    return {rounded(view.x * camera.projection.multiplier_x), rounded(-view.y * camera.projection.multiplier_y),
            rounded(view.z)};
}

RayTriangle::Side RayTriangle::side(const RayCorner& from, const RayCorner& to) {
    return {Wide{from.y} * to.z - Wide{from.z} * to.y, Wide{from.z} * to.x - Wide{from.x} * to.z,
            Wide{from.x} * to.y - Wide{from.y} * to.x};
}

std::optional<RayTriangle> RayTriangle::make(const RayCorner& a, const RayCorner& b, const RayCorner& c) {
    const Side first = side(a, b);
    RayTriangle triangle;
    triangle.winding_ = sign_of_sum(first.x, first.y, first.z, c);
    if (triangle.winding_ == 0) return std::nullopt;
    if (triangle.winding_ > 0)
        triangle.sides_ = {first, side(b, c), side(c, a)};
    else
        triangle.sides_ = {side(b, a), side(a, c), side(c, b)};
    return triangle;
}

void RayTriangle::limit(const Side& side, const RayGrid& grid, int row, Interval& interval) {
    const bool owns_its_rays = side.x > 0 || (side.x == 0 && side.y > 0);  // a left edge, or a top edge
    // Inside: start + column * step >= 0.
    const Wide start = side.x * grid.x(0) + side.y * grid.y(row) + side.z * kRayUnit - (owns_its_rays ? 0 : 1);
    const Wide step = side.x * kRayUnit;
    if (step > 0)
        interval.first = std::max(interval.first, clamped(-floor_quotient(start, step), grid.width_px));
    else if (step < 0)
        interval.end = std::min(interval.end, clamped(floor_quotient(start, -step) + 1, grid.width_px));
    else if (start < 0)
        interval.end = 0;
}

Interval RayTriangle::inside(const RayGrid& grid, int row) const {
    Interval interval{0, grid.width_px};
    for (const Side& side : sides_) limit(side, grid, row, interval);
    return interval;
}

std::vector<RayTriangle> make_ray_fan(std::span<const RayCorner> corners) {
    std::vector<RayTriangle> fan;
    for (std::size_t i = 2; i < corners.size(); ++i)
        if (const auto triangle = RayTriangle::make(corners[0], corners[i - 1], corners[i])) fan.push_back(*triangle);
    return fan;
}

}  // namespace oblong::reference
