#include "engine/platform/sdl/frame_pacing.h"

#include <gtest/gtest.h>

namespace oblong {
namespace {

// The time at which the last of `count` pictures is shown that take `drawing_us` each, the first at `start_us`.
std::uint64_t show_pictures(FramePacing& pacing, std::uint64_t start_us, int count, std::uint64_t drawing_us,
                            std::int32_t frames_per_second) {
    std::uint64_t now_us = start_us;
    for (int i = 0; i < count; ++i) {
        if (i > 0) now_us += drawing_us;
        now_us += pacing.next_wait_us(now_us, frames_per_second);
    }
    return now_us;
}

TEST(FramePacing, AnHourAtThirtyFiveIsAnHourToTheMicrosecond) {
    FramePacing pacing;
    EXPECT_EQ(show_pictures(pacing, 77, 35 * 3600 + 1, 4'321, 35), 77 + 3'600'000'000u);
}

TEST(FramePacing, WithoutALimitNobodyWaits) {
    FramePacing pacing;
    EXPECT_EQ(show_pictures(pacing, 5, 1001, 10, 0), 5 + 10'000u);
}

TEST(FramePacing, PicturesThatTakeLongerThanTheirTimeDoNotWait) {
    FramePacing pacing;
    EXPECT_EQ(show_pictures(pacing, 0, 101, 25'000, 60), 2'500'000u);
}

TEST(FramePacing, ALatePictureDoesNotDelayTheNext) {
    FramePacing pacing;
    show_pictures(pacing, 0, 1, 0, 50);                  // the next is due at 20 ms
    EXPECT_EQ(pacing.next_wait_us(33'000, 50), 0u);      // 13 ms late
    EXPECT_EQ(pacing.next_wait_us(34'000, 50), 6'000u);  // due at 40 ms, not at 53
}

TEST(FramePacing, AfterAPauseItDoesNotHurryToCatchUp) {
    FramePacing pacing;
    show_pictures(pacing, 0, 10, 1'000, 100);
    EXPECT_EQ(pacing.next_wait_us(9'000'000, 100), 0u);
    EXPECT_EQ(pacing.next_wait_us(9'000'500, 100), 9'500u);
}

TEST(FramePacing, AnotherLimitHoldsFromTheNextPictureOn) {
    FramePacing pacing;
    show_pictures(pacing, 0, 10, 1'000, 10);
    EXPECT_EQ(pacing.next_wait_us(901'000, 200), 0u);
    EXPECT_EQ(pacing.next_wait_us(902'000, 200), 4'000u);
}

}  // namespace
}  // namespace oblong
