#include "engine/math/vec.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"
#include "engine/fixed/wide.h"

namespace oblong {
namespace {

template <std::size_t N>
std::uint64_t length_of(const std::array<std::int64_t, N>& vector) {
    Uint128 sum;
    for (const std::int64_t component : vector) {
        const std::uint64_t size = detail::magnitude(component);
        sum = portable::add(sum, native::product_to_128(size, size));
    }
    return integer_root(sum);
}

/// Scales a vector by a power of two so that the largest component has 61 bits: short vectors gain precision, and a sum
/// of four squares fits 128 bits.
template <std::size_t N>
std::array<std::int64_t, N> scaled_to_61_bits(std::array<std::int64_t, N> vector, std::uint64_t largest) {
    const int shift = std::countl_zero(largest) - 3;
    for (std::int64_t& component : vector)
        component = shift >= 0 ? component * (std::int64_t{1} << shift) : floor_shift(component, -shift);
    return vector;
}

template <std::size_t N>
std::array<Unit, N> unit_of(const std::array<std::int64_t, N>& vector) {
    std::uint64_t largest = 0;
    for (const std::int64_t component : vector) largest = std::max(largest, detail::magnitude(component));
    std::array<Unit, N> result{};
    if (largest == 0) return result;

    const std::array<std::int64_t, N> scaled = scaled_to_61_bits(vector, largest);
    const auto size = static_cast<std::int64_t>(length_of(scaled));
    for (std::size_t i = 0; i < N; ++i)
        result[i] = Unit::from_raw(static_cast<std::int32_t>(mul_div(scaled[i], Unit::from_int(1).raw, size)));
    return result;
}

}  // namespace

std::uint64_t length_of_raw(const std::array<std::int64_t, 3>& vector) {
    return length_of(vector);
}

std::array<Unit, 3> normalised_raw(const std::array<std::int64_t, 3>& vector) {
    return unit_of(vector);
}

std::array<Unit, 4> normalised_raw(const std::array<std::int64_t, 4>& vector) {
    return unit_of(vector);
}

Vec3<Unit> perpendicular_to(const Vec3<Unit>& direction) {
    if (direction == Vec3<Unit>{}) return {Unit::from_int(1), {}, {}};
    const std::int64_t x = std::abs(std::int64_t{direction.x.raw}), y = std::abs(std::int64_t{direction.y.raw}),
                       z = std::abs(std::int64_t{direction.z.raw});
    // The axis farthest from the direction gives the longest cross product.
    Vec3<Unit> axis;
    (z <= x && z <= y ? axis.z : x <= y ? axis.x : axis.y) = Unit::from_int(1);
    return normalised(cross(direction, axis));
}

Vec3<World> middle_of(std::span<const Vec3<World>> points) {
    Vec3<WorldWide> sum;
    for (const Vec3<World>& point : points) sum = sum + convert<WorldWide>(point);
    const auto count = WorldWide::from_int(std::ssize(points));
    return {divide<World>(sum.x, count), divide<World>(sum.y, count), divide<World>(sum.z, count)};
}

std::optional<RayDistance> intersect_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction,
                                         const Plane& plane) {
    const Sine60 approach = -dot(direction, plane.normal);
    if (approach == Sine60{}) return std::nullopt;
    return divide<RayDistance>(distance_to_plane(world_origin, plane), approach);
}

Vec3<World> point_on_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction, RayDistance distance) {
    const auto along = [&distance](World from, Unit slope) {
        return saturated_to<World>(saturating_sum(from.raw, product<WorldWide>(slope, distance).raw));
    };
    return {along(world_origin.x, direction.x), along(world_origin.y, direction.y), along(world_origin.z, direction.z)};
}

}  // namespace oblong
