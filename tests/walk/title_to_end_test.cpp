#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

using TitleToEnd = WalkedLevel;

// Enter on the title's "Walk" starts the demo that is to be replayed; what the program records of it is that demo, to
// the end of the level.
TEST_F(TitleToEnd, TheRecordedWalkGoesThroughTheWholeProgram) {
    Options options;
    options.replay = test::build_folder() + "/assets/walk.demo";
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

}  // namespace
}  // namespace oblong::test
