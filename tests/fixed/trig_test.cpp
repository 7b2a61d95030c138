#include "engine/fixed/trig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/fixed/sine_methods.h"

namespace oblong {

namespace {

// The references are the C library's 80-bit functions, right within 2^-63: enough to tell steps of 2^-60 apart.
constexpr long double kTurn = 2 * std::numbers::pi_v<long double>;

long double radians_of(Angle angle) {
    return angle.bam * (kTurn / 65536);
}
long double value_of(Sine60 sine60) {
    return std::ldexp(static_cast<long double>(sine60.raw), -60);
}

TEST(Trig, SineAndCosineOfEveryAngleAreTheNearestStep) {
    for (int bam = 0; bam < 65536; ++bam) {
        const Angle angle = Angle::from_bam(bam);
        ASSERT_LE(std::abs(sine(angle).raw - std::ldexp(std::sin(radians_of(angle)), 30)), 0.5001) << bam;
        ASSERT_LE(std::abs(cosine(angle).raw - std::ldexp(std::cos(radians_of(angle)), 30)), 0.5001) << bam;
    }
}

TEST(Trig, UnroundedSineAndCosineOfEveryAngleHoldTheirBound) {
    for (int bam = 0; bam < 65536; ++bam) {
        const Angle angle = Angle::from_bam(bam);
        const SineCosine60 both = sine_cosine(angle);
        ASSERT_LE(std::abs(value_of(both.sine) - std::sin(radians_of(angle))), 0x1p-58) << bam;
        ASSERT_LE(std::abs(value_of(both.cosine) - std::cos(radians_of(angle))), 0x1p-58) << bam;
    }
}

TEST(HardCaseA7, SymmetriesHoldBitForBit) {
    for (int bam = 0; bam < 65536; ++bam) {
        const Angle a = Angle::from_bam(bam);
        ASSERT_EQ(sine(-a), -sine(a)) << bam;
        ASSERT_EQ(sine(a + kHalfTurn), -sine(a)) << bam;
        ASSERT_EQ(cosine(a), sine(a + kQuarterTurn)) << bam;
        ASSERT_EQ(cosine(-a), cosine(a)) << bam;
        ASSERT_EQ(sine(kHalfTurn - a), sine(a)) << bam;
    }
}

TEST(HardCaseA7, SquaresAddUpToOne) {
    for (int bam = 0; bam < 65536; ++bam) {
        const std::int64_t s = sine(Angle::from_bam(bam)).raw, c = cosine(Angle::from_bam(bam)).raw;
        // Half a step of error in each: at most (|s| + |c|) / 2 + 1/2 steps of 2^-60 x 2^30.
        ASSERT_LE(std::abs(s * s + c * c - (std::int64_t{1} << 60)), std::int64_t{1} << 31) << bam;
    }
}

TEST(HardCaseA8, AnAngleIsNeverNegative) {
    EXPECT_EQ(Angle::from_bam(-3).bam, 65533);
    EXPECT_EQ((-Angle::from_bam(3)).bam, 65533);
    EXPECT_EQ((Angle::from_bam(1) - Angle::from_bam(2)).bam, 65535);
    EXPECT_EQ(Angle::from_bam(std::numeric_limits<std::int64_t>::min()).bam, 0);
}

TEST(Trig, QuartersOfATurnAreExact) {
    EXPECT_EQ(sine(Angle{}), Unit{});
    EXPECT_EQ(sine(kQuarterTurn), Unit::from_int(1));
    EXPECT_EQ(sine(kHalfTurn), Unit{});
    EXPECT_EQ(cosine(kHalfTurn), Unit::from_int(-1));
}

TEST(Trig, SineAndCosineOfDegreesHoldTheirBound) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200'000; ++i) {
        const auto degrees = Degrees::from_raw(static_cast<std::int64_t>(random() % (std::uint64_t{180} << 48)));
        const long double radians = std::ldexp(static_cast<long double>(degrees.raw), -48) * (kTurn / 360);
        const SineCosine60 both = sine_cosine(degrees);
        ASSERT_LE(std::abs(value_of(both.sine) - std::sin(radians)), 0x1p-57) << degrees.raw;
        ASSERT_LE(std::abs(value_of(both.cosine) - std::cos(radians)), 0x1p-57) << degrees.raw;
    }
}

TEST(Trig, FortyFiveDegreesHaveATangentOfExactlyOne) {
    const SineCosine60 both = sine_cosine(Degrees::from_int(45));
    EXPECT_EQ(both.sine, both.cosine);
    EXPECT_EQ(sine_cosine(Degrees::from_int(90)).sine, Sine60::from_int(1));
    EXPECT_EQ(sine_cosine(Degrees::from_int(90)).cosine, Sine60{});
}

TEST(Trig, DegreesBecomeTheNearestAngleWhateverTheirSign) {
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(90)), kQuarterTurn);
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(-90)), -kQuarterTurn);
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(360 * 90 + 180)), kHalfTurn);
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(1)), Angle::from_bam(182));  // 182.04
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(-1)), Angle::from_bam(-182));
    EXPECT_EQ(degrees_to_angle(Degrees::from_int(25)), Angle::from_bam(4551));  // 4551.11
    const std::int64_t half_a_bam_48 = (std::int64_t{180} << 48) / 65536;
    EXPECT_EQ(degrees_to_angle(Degrees::from_raw(half_a_bam_48)), Angle::from_bam(1));
    EXPECT_EQ(degrees_to_angle(Degrees::from_raw(half_a_bam_48 - 1)), Angle::from_bam(0));
    EXPECT_EQ(degrees_to_angle(Degrees::from_raw(-half_a_bam_48)), Angle::from_bam(0));
    EXPECT_EQ(degrees_to_angle(Degrees::lowest()), degrees_to_angle(Degrees::from_int(-32768 + 360 * 100)));
}

TEST(Trig, ArctangentIsTheNearestAngle) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100'000; ++i) {
        const auto y = floor_shift(static_cast<std::int64_t>(random()), static_cast<int>(random() % 64));
        const auto x = floor_shift(static_cast<std::int64_t>(random()), static_cast<int>(random() % 64));
        if (x == 0 && y == 0) continue;
        const long double exact =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x)) / (kTurn / 65536);
        const long double off = std::remainder(arctangent2(y, x).bam - exact, 65536.0L);
        ASSERT_LE(std::abs(off), 0.5L + 1e-10L) << y << " " << x;
    }
}

TEST(Trig, ArctangentOfTheAxesAndDiagonalsIsExactAtEveryLength) {
    constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::min();
    EXPECT_EQ(arctangent2(0, 0), Angle{});
    EXPECT_EQ(arctangent2(0, kLongest), kHalfTurn);
    EXPECT_EQ(arctangent2(kLongest, 0), -kQuarterTurn);
    EXPECT_EQ(arctangent2(kLongest, kLongest), Angle::from_bam(-0x6000));
    EXPECT_EQ(arctangent2(1, 1), Angle::from_bam(0x2000));
    EXPECT_EQ(arctangent2(-1, 1), Angle::from_bam(-0x2000));
    EXPECT_EQ(arctangent2(1, 0), kQuarterTurn);
}

// The error of every method at every angle is in tests/exhaustive.

TEST(HardCaseA7, QuarterTableIsSymmetricBitForBit) {
    constexpr auto kMethod = SineMethod::Quarter1024Lerp;
    for (int bam = 0; bam < 65536; ++bam) {
        const Angle a = Angle::from_bam(bam);
        ASSERT_EQ(sine(-a, kMethod), -sine(a, kMethod)) << bam;
        ASSERT_EQ(sine(a + kHalfTurn, kMethod), -sine(a, kMethod)) << bam;
        ASSERT_EQ(cosine(a, kMethod), sine(a + kQuarterTurn, kMethod)) << bam;
        ASSERT_EQ(sine(kHalfTurn - a, kMethod), sine(a, kMethod)) << bam;
    }
}

TEST(HardCaseA7, SquaresOfTheQuarterTableAddUpToOneWithin2ToTheMinus20) {
    for (int bam = 0; bam < 65536; ++bam) {
        const std::int64_t s = sine(Angle::from_bam(bam), SineMethod::Quarter1024Lerp).raw;
        const std::int64_t c = cosine(Angle::from_bam(bam), SineMethod::Quarter1024Lerp).raw;
        ASSERT_LE(std::abs(s * s + c * c - (std::int64_t{1} << 60)), std::int64_t{1} << 40) << bam;
    }
}

/// What the engine does not use them for: these methods give other bits at -a than at a.
TEST(HardCaseA7, LinesBetweenFlooredEntriesAndCordicAreNotOdd) {
    for (const SineMethod method : {SineMethod::Lerp256, SineMethod::Cordic16}) {
        int odd_one_out = 0;
        for (int bam = 0; bam < 65536; ++bam) {
            const Angle a = Angle::from_bam(bam);
            odd_one_out += sine(-a, method) != -sine(a, method) ? 1 : 0;
        }
        EXPECT_GT(odd_one_out, 0) << static_cast<int>(method);
    }
}

TEST(SineMethods, TablesAreExactAtTheirEntries) {
    for (int entry = 0; entry < 256; ++entry) {
        const Angle angle = Angle::from_bam(entry * 256);
        for (const SineMethod method : {SineMethod::Nearest256, SineMethod::Lerp256, SineMethod::Quarter1024Lerp})
            ASSERT_EQ(sine(angle, method), sine(angle)) << static_cast<int>(method) << " " << entry;
    }
}

TEST(SineMethods, NearestIsAStepFunctionCentredOnItsEntries) {
    EXPECT_EQ(sine(Angle::from_bam(127), SineMethod::Nearest256), Unit{});
    EXPECT_EQ(sine(Angle::from_bam(128), SineMethod::Nearest256), sine(Angle::from_bam(256)));
    EXPECT_EQ(sine(Angle::from_bam(-128), SineMethod::Nearest256), Unit{});
    EXPECT_EQ(sine(Angle::from_bam(-129), SineMethod::Nearest256), sine(Angle::from_bam(-256)));
}

}  // namespace

}  // namespace oblong
