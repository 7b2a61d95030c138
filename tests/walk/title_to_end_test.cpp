#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

using TitleToEnd = WalkedLevel;

// Enter on the title's "Walk" starts the demo that is to be replayed; what the program records of it is that demo, to
// the end of the level.
TEST_F(TitleToEnd, TheRecordedWalkGoesThroughTheWholeProgram) {
    Options options;
    options.replay = OBLONG_BUILD_DIR "/assets/walk.demo";
    options.preferences.game_speed_100 = 800;
    const Demo walk = decode_demo(read_file(options.replay));
    constexpr std::int64_t kTitlePolls = 20, kEndPolls = 20;
    const auto polls = kTitlePolls + static_cast<std::int64_t>(walk.ticks.size()) / 8 + kEndPolls;
    ScriptedPlatform platform(polls, [&](std::int64_t poll) { return poll == kTitlePolls ? accept() : Controls{}; });

    Demo recorded = record(options, platform);
    // The last frame of the walk may hold some ticks more than the demo.
    ASSERT_GE(recorded.ticks.size(), walk.ticks.size());
    EXPECT_LT(recorded.ticks.size(), walk.ticks.size() + 8) << "the end's page does not stop the game";
    expect_all_found(replayed(recorded));
    recorded.ticks.resize(walk.ticks.size());
    EXPECT_EQ(recorded, walk);
}

// The same in a window: tests/walk/window_walk.py.
TEST_F(TitleToEnd, TheRecordedWalkGoesThroughAWindow) {
    constexpr int kSkipped = 77;
    const std::string recorded = folder_.path("recorded.demo"), picture = OBLONG_BUILD_DIR "/walk_end.png";
    const std::string command = "python3 '" OBLONG_SOURCE_DIR "/tests/walk/window_walk.py' '" OBLONG_BUILD_DIR "' '" +
                                recorded + "' '" + picture + "'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kSkipped) GTEST_SKIP() << "see above for what is missing";
    ASSERT_EQ(WEXITSTATUS(status), 0);

    const Demo walk = decode_demo(read_file(OBLONG_BUILD_DIR "/assets/walk.demo"));
    Demo seen = decode_demo(read_file(recorded));
    expect_all_found(replayed(seen));
    ASSERT_GE(seen.ticks.size(), walk.ticks.size());
    seen.ticks.resize(walk.ticks.size());
    EXPECT_EQ(seen, walk);
}

}  // namespace
}  // namespace oblong::test
