#include "engine/level/bsp_floats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace oblong {

namespace {

constexpr double kBoxLimit = 1 << 20;

double to_double(FloatBits value) {
    return std::bit_cast<float>(value.bits);
}

/// The value in units of 2^-fraction_bits: exact, a double has exponents to spare.
double scale(FloatBits value, int fraction_bits) {
    return std::ldexp(to_double(value), fraction_bits);
}

/// Exact for every float: the sum rounds only where the half no longer matters.
double round_half_up(double value) {
    return std::floor(value + 0.5);
}

double texel_coordinate(const FloatBits3& p, const std::array<FloatBits, 4>& axis) {
    return to_double(p[0]) * to_double(axis[0]) + to_double(p[1]) * to_double(axis[1]) +
           to_double(p[2]) * to_double(axis[2]) + to_double(axis[3]);
}

}  // namespace

std::optional<std::int64_t> to_fixed(FloatBits value, int fraction_bits, std::int32_t limit) {
    if (!(std::abs(to_double(value)) < limit)) return std::nullopt;
    return static_cast<std::int64_t>(round_half_up(scale(value, fraction_bits)));
}

std::int32_t rest_of_fixed(FloatBits value, int fraction_bits) {
    const double steps = scale(value, fraction_bits);
    return static_cast<std::int32_t>(round_half_up(std::ldexp(steps - round_half_up(steps), 30)));
}

std::optional<std::int32_t> floor_to_int(FloatBits value) {
    if (!(std::abs(to_double(value)) <= kBoxLimit)) return std::nullopt;
    return static_cast<std::int32_t>(std::floor(to_double(value)));
}

std::optional<std::int32_t> ceil_to_int(FloatBits value) {
    if (!(std::abs(to_double(value)) <= kBoxLimit)) return std::nullopt;
    return static_cast<std::int32_t>(std::ceil(to_double(value)));
}

std::string describe(FloatBits value) {
    const double number = to_double(value);
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
    return std::to_string(number);
}

TexelRange texel_range(std::span<const FloatBits3> polygon, const std::array<FloatBits, 4>& axis) {
    double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();
    for (const FloatBits3& p : polygon) {
        const double texel = texel_coordinate(p, axis);
        least = std::min(least, texel);
        most = std::max(most, texel);
    }
    const auto first_cell = static_cast<std::int32_t>(std::floor(least / 16));
    const auto last_cell = static_cast<std::int32_t>(std::ceil(most / 16));
    return {first_cell * 16, (last_cell - first_cell) * 16};
}

}  // namespace oblong
