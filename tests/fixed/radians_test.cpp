#include "engine/fixed/radians.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace oblong {
namespace {

constexpr long double kHalfPi = std::numbers::pi_v<long double> / 2;

Sine60 nearest_60(long double value) {
    return Sine60::from_raw(std::llroundl(std::ldexp(value, 60)));
}

TEST(Radians, ComeBackFromTheirSineAndCosine) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 50'000; ++i) {
        const long double angle = std::ldexp(static_cast<long double>(random()), -64) * kHalfPi;
        const Radians got = radians_of({nearest_60(std::sin(angle)), nearest_60(std::cos(angle))});
        ASSERT_LE(std::abs(std::ldexp(static_cast<long double>(got.raw), -60) - angle), 0x1p-56L) << angle;
    }
    EXPECT_EQ(radians_of({Sine60{}, Sine60::from_int(1)}), Radians{});
}

TEST(Radians, HaveTheSineOfTheirValue) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 50'000; ++i) {
        const auto angle = Radians::from_raw(static_cast<std::int64_t>(random() % 1'810'000'000'000'000'000));
        const long double exact = std::sin(std::ldexp(static_cast<long double>(angle.raw), -60));
        ASSERT_LE(std::abs(std::ldexp(static_cast<long double>(sine(angle).raw), -60) - exact), 0x1p-57L) << angle.raw;
    }
}

TEST(HalfAngle, HasItsSineAndCosine) {
    for (int bam = 0; bam < 65536; ++bam) {
        const SineCosine60 both = half_angle_sine_cosine(Angle::from_bam(bam));
        const long double half = bam * kHalfPi / 32768;
        ASSERT_LE(std::abs(std::ldexp(static_cast<long double>(both.sine.raw), -60) - std::sin(half)), 0x1p-58L) << bam;
        ASSERT_LE(std::abs(std::ldexp(static_cast<long double>(both.cosine.raw), -60) - std::cos(half)), 0x1p-58L);
    }
}

}  // namespace
}  // namespace oblong
