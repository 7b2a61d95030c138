#include "engine/platform/headless.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace oblong {
namespace {

TEST(Headless, ShowsTheFramesThatWereAskedForInOrder) {
    std::array<std::uint8_t, 6> pixels{};
    std::vector<std::uint8_t> firsts;
    HeadlessPlatform platform(
        3, 35, [](std::int64_t) { return PlatformInput{}; },
        [&](Framebuffer picture, const Palette&) { firsts.push_back(picture.pixels[0]); });
    while (platform.is_open()) {
        platform.poll();
        ++pixels[0];
        platform.present({pixels.data(), 3, 2, 3}, Palette{}, PresentRect{});
    }
    EXPECT_EQ(firsts, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(Headless, ScriptIsAskedOncePerPoll) {
    HeadlessPlatform platform(
        1, 35,
        [](std::int64_t poll) {
            PlatformInput input;
            input.events.push_back({InputEvent::Kind::MouseMotion, {}, static_cast<std::int32_t>(poll), 0});
            return input;
        },
        [](Framebuffer, const Palette&) {});
    for (std::int32_t poll = 0; poll < 5; ++poll) EXPECT_EQ(platform.poll().events.at(0).x, poll);
}

// A game that counts ticks as time * rate / second must get exactly one a poll, for ever.
TEST(Headless, ClockGivesOneTickAPoll) {
    HeadlessPlatform platform(
        1, 35, [](std::int64_t) { return PlatformInput{}; }, [](Framebuffer, const Palette&) {});
    for (std::uint64_t tick = 0; tick < 100'000; ++tick) {
        ASSERT_EQ(platform.now_us() * 35 / 1'000'000, tick);
        platform.poll();
    }
}

}  // namespace
}  // namespace oblong
