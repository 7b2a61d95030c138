#include "engine/frame/observers.h"

#include <gtest/gtest.h>

namespace oblong {

namespace {

constexpr std::int64_t kReading_ns = 30;
std::int64_t now_ns = 0, readings = 0;

std::int64_t slow_clock_ns() {
    ++readings;
    return now_ns += kReading_ns;
}

// The walk and faces of models alternate. Both sums are right, although the clock is read for only one in 17, and do
// not include the time to read it.
TEST(Observers, SamplesStandForAllOfTheirKind) {
    PassTimes times{slow_clock_ns};
    now_ns = readings = 0;
    for (int i = 0; i < 1700; ++i) {
        {
            const SampledStopwatch watch(&times, &PassTimes::walk_ns);
            now_ns += 100;
        }
        const SampledStopwatch watch(&times, Effect::BrushModels);
        now_ns += 700;
    }
    EXPECT_EQ(times.walk_ns, 1700 * 100);
    EXPECT_EQ(item(times.effects_ns, Effect::BrushModels), 1700 * 700);
    EXPECT_EQ(readings, 3 * 2 * 1700 / 17);
}

TEST(Observers, WithoutTimesNothingIsRead) {
    readings = 0;
    { const SampledStopwatch watch(nullptr, Effect::BrushModels); }
    EXPECT_EQ(readings, 0);
}

}  // namespace

}  // namespace oblong
