#include "engine/fixed/reciprocal.h"

#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

constexpr std::uint64_t kUnity62 = std::uint64_t{1} << 62;
constexpr std::uint64_t kFirstMantissa = std::uint64_t{1} << 31;

constexpr std::uint64_t nearest_quotient(std::uint64_t n, std::uint64_t d) {
    return (n + d / 2) / d;
}

/// The reciprocals of the middles of 2^Bits equal parts of the mantissas, which minimise the relative error. A Newton
/// step squares the error. As a part begins with a smaller error than the one before ended with, the step's result
/// could rise there: with 1,024 parts by a relative 2^-31, which the next mantissa's decrease makes up for.
template <int Bits>
constexpr auto reciprocals_of_middles() {
    std::array<std::uint32_t, std::size_t{1} << Bits> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i)
        table[i] =
            static_cast<std::uint32_t>(nearest_quotient(kUnity62, kFirstMantissa + ((2 * i + 1) << (30 - Bits))));
    return table;
}

constexpr auto kMiddles256 = reciprocals_of_middles<8>();
constexpr auto kMiddles1024 = reciprocals_of_middles<10>();

/// A Newton step r + r (1 - m r), floored, with `more_bits` (0 to 10) in addition to 31.
std::uint64_t newton_step(std::uint32_t mantissa, std::uint64_t r, int more_bits) {
    const auto error_62 = static_cast<std::int64_t>(kUnity62 - mantissa * r);
    // The table's error is below 2^-9, so this has 54 bits; 40 fraction bits are enough.
    const std::int64_t correction = static_cast<std::int64_t>(r) * floor_shift(error_62, 22);
    return (r << more_bits) + static_cast<std::uint64_t>(floor_shift(correction, 40 - more_bits));
}

/// The first step keeps 10 more bits than the result, so that the second is within 1/8 of a step before rounding, and
/// cannot rise where the true quotient falls by at least 1/4 of a step.
std::uint32_t two_newton_steps(std::uint32_t mantissa, std::uint32_t seed) {
    constexpr int kMoreBits = 10;
    const std::uint64_t r = newton_step(mantissa, seed, kMoreBits);
    // 2^72 - m r modulo 2^64; it is below 2^55, so the low 64 bits are enough.
    const auto error_72 = static_cast<std::int64_t>(0 - mantissa * r);
    const std::int64_t correction = static_cast<std::int64_t>(r >> kMoreBits) * floor_shift(error_72, 24);
    const auto sharpened = static_cast<std::int64_t>(r) + floor_shift(correction, 72 - 24 - kMoreBits);
    return static_cast<std::uint32_t>(rounded_shift(sharpened, kMoreBits, Rounding::NearestHalfUp));
}

}  // namespace

std::uint32_t mantissa_reciprocal(std::uint32_t mantissa, ReciprocalMethod method) {
    switch (method) {
        case ReciprocalMethod::Table256:
            return kMiddles256[(mantissa >> 23) & 0xff];
        case ReciprocalMethod::Table256Newton:
            return static_cast<std::uint32_t>(newton_step(mantissa, kMiddles256[(mantissa >> 23) & 0xff], 0));
        case ReciprocalMethod::Table1024Newton:
            return static_cast<std::uint32_t>(newton_step(mantissa, kMiddles1024[(mantissa >> 21) & 0x3ff], 0));
        case ReciprocalMethod::Table256TwoNewton:
            return two_newton_steps(mantissa, kMiddles256[(mantissa >> 23) & 0xff]);
        case ReciprocalMethod::Exact:
            break;
    }
    return static_cast<std::uint32_t>(nearest_quotient(kUnity62, mantissa));
}

}  // namespace oblong
