#include <algorithm>

#include "tests/controls/pad_pilot.h"
#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

using GamepadWalk = WalkedLevel;

bool accepts(const PlatformInput& input) {
    const InputEvent wanted{InputEvent::Kind::Press, pad_button(PadButton::A), 0, 0};
    return std::find(input.events.begin(), input.events.end(), wanted) != input.events.end();
}

// A accepts the title's "Walk"; then sticks and A lead along the recorded walk to the end of the level. Nothing but
// events of a pad reaches the program.
TEST_F(GamepadWalk, APadAloneWalksFromTheTitleToTheEnd) {
    const Demo walk = decode_demo(read_file(test::build_folder() + "/assets/walk.demo"));
    const UnseenWindow window;
    VirtualPad pad;
    PadPilot pilot(pad);
    constexpr std::int64_t kPress = 5, kRelease = 7, kEndPolls = 10;
    std::size_t played = 0;
    bool has_begun = false;
    const std::int64_t polls = kPress + static_cast<std::int64_t>(walk.ticks.size()) + kEndPolls;
    ScriptedPlatform platform(polls, [&](std::int64_t poll) {
        if (poll == kPress) pad.press(PadButton::A);
        if (poll == kRelease && !has_begun) pad.release(PadButton::A);
        if (has_begun) pilot.steer(played < walk.ticks.size() ? walk.ticks[played++].input : TickInput{});
        const PlatformInput input = window.input->poll();
        has_begun |= accepts(input);
        return input;
    });

    Demo recorded = record({}, platform);
    ASSERT_TRUE(has_begun);
    ASSERT_GE(recorded.ticks.size(), walk.ticks.size());
    expect_all_found(replayed(recorded));
    recorded.ticks.resize(walk.ticks.size());
    EXPECT_EQ(recorded, walk);
}

}  // namespace
}  // namespace oblong::test
