#include "engine/fixed/sine_methods.h"

#include <gtest/gtest.h>

#include "engine/fixed/trig.h"

namespace oblong {
namespace {

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
