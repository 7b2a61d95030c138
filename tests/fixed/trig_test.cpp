#include "engine/fixed/trig.h"

#include <gtest/gtest.h>

#include <array>
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
        ASSERT_EQ(sine(angle), sine(angle, SineMethod::NearestStep)) << bam;
        const SineCosine60 both = sine_cosine(angle);  // before it is rounded
        ASSERT_LE(std::abs(value_of(both.sine) - std::sin(radians_of(angle))), 0x1p-58) << bam;
        ASSERT_LE(std::abs(value_of(both.cosine) - std::cos(radians_of(angle))), 0x1p-58) << bam;
    }
}

TEST(HardCaseA8, AnAngleIsNeverNegative) {
    EXPECT_EQ(Angle::from_bam(-3).bam, 65533);
    EXPECT_EQ((-Angle::from_bam(3)).bam, 65533);
    EXPECT_EQ((Angle::from_bam(1) - Angle::from_bam(2)).bam, 65535);
    EXPECT_EQ(Angle::from_bam(std::numeric_limits<std::int64_t>::min()).bam, 0);
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
    const std::int64_t half_a_bam_48 = (std::int64_t{180} << 48) / 65536;
    for (const auto& [degrees_48, bam] :
         {std::pair{std::int64_t{90} << 48, 0x4000},
          {-(std::int64_t{90} << 48), -0x4000},
          {std::int64_t{360 * 90 + 180} << 48, 0x8000},
          {std::int64_t{1} << 48, 182},  // 182.04
          {-(std::int64_t{1} << 48), -182},
          {std::int64_t{25} << 48, 4551},  // 4551.11
          {half_a_bam_48, 1},
          {half_a_bam_48 - 1, 0},
          {-half_a_bam_48, 0},
          {Degrees::lowest().raw, (-32768 + 360 * 91) * 65536 / 360}})  // -8 degrees and whole turns: 1456.4
        EXPECT_EQ(degrees_to_angle(Degrees::from_raw(degrees_48)), Angle::from_bam(bam)) << degrees_48;
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
    using Row = std::array<std::int64_t, 3>;
    for (const auto& [y, x, bam] :
         {Row{0, 0, 0}, Row{0, kLongest, 0x8000}, Row{kLongest, 0, -0x4000}, Row{kLongest, kLongest, -0x6000},
          Row{1, 1, 0x2000}, Row{-1, 1, -0x2000}, Row{1, 0, 0x4000}})
        EXPECT_EQ(arctangent2(y, x), Angle::from_bam(bam)) << y << ", " << x;
}

/// The error of every method at every angle is in tests/exhaustive.
TEST(HardCaseA7, SymmetriesHoldBitForBitAndSquaresAddUpToOne) {
    // Half a step of error in each: at most (|s| + |c|) / 2 + 1/2 steps of 2^-60 x 2^30; of the table 2^-20.
    for (const auto& [method, bits] : {std::pair{SineMethod::NearestStep, 31}, {SineMethod::Quarter1024Lerp, 40}})
        for (int bam = 0; bam < 65536; ++bam) {
            const Angle a = Angle::from_bam(bam);
            const std::int64_t s = sine(a, method).raw, c = cosine(a, method).raw;
            ASSERT_EQ(sine(-a, method).raw, -s) << bam;
            ASSERT_EQ(sine(a + kHalfTurn, method).raw, -s) << bam;
            ASSERT_EQ(sine(a + kQuarterTurn, method).raw, c) << bam;
            ASSERT_EQ(cosine(-a, method).raw, c) << bam;
            ASSERT_EQ(sine(kHalfTurn - a, method).raw, s) << bam;
            ASSERT_LE(std::abs(s * s + c * c - (std::int64_t{1} << 60)), std::int64_t{1} << bits) << bam;
        }
}

/// The other settings of the dial give other bits at -a than at a.
TEST(HardCaseA7, OtherMethodsAreNotOdd) {
    for (const SineMethod method :
         {SineMethod::Nearest256, SineMethod::Lerp256, SineMethod::Cordic16, SineMethod::Cordic30}) {
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
