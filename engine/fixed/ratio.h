#pragma once

#include <cstdint>
#include <numeric>

namespace oblong {

/// An exact small fraction, such as the aspect ratio of a display (4:3) or a pixel (5:6). The denominator is positive.
struct Ratio {
    std::int64_t numerator = 0, denominator = 1;

    constexpr Ratio reduced() const {
        const std::int64_t divisor = std::gcd(numerator, denominator);
        return divisor == 0 ? *this : Ratio{numerator / divisor, denominator / divisor};
    }
    constexpr Ratio operator*(Ratio other) const {
        return Ratio{numerator * other.numerator, denominator * other.denominator}.reduced();
    }
    constexpr Ratio inverse() const { return Ratio{denominator, numerator}; }
    constexpr bool operator==(Ratio other) const {
        return numerator * other.denominator == other.numerator * denominator;
    }
};

}  // namespace oblong
