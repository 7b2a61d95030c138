#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "engine/files/files.h"
#include "game/simulation/demo.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

// In a window on an X server of its own, from the title by the keyboard to the page at the end, and out again: what was
// played there is the recorded walk, state by state.
TEST(WindowWalk, TheRecordedWalkIsPlayedFromTheTitleToTheEnd) {
    const std::string folder = test::build_folder() + "/window_walk", recorded = folder + "/recorded.demo";
    make_folder(folder);
    const std::string command = "HOME='" + folder + "' XDG_CONFIG_HOME='" + folder + "' XDG_DATA_HOME='" + folder +
                                "' python3 '" + test::source_folder() + "/tests/walk/window_walk.py' '" +
                                test::build_folder() + "' '" + recorded + "' '" + folder + "/end.png'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    constexpr int kSkipped = 77;
    if (WEXITSTATUS(status) == kSkipped) GTEST_SKIP() << "see above for what is missing";
    ASSERT_EQ(WEXITSTATUS(status), 0);
    const Demo walk = read_parsed(test::build_folder() + "/assets/walk.demo", decode_demo);
    const Demo played = read_parsed(recorded, decode_demo);
    EXPECT_EQ(played.start_hash, walk.start_hash);
    ASSERT_GE(played.ticks.size(), walk.ticks.size()) << "nothing moves after the end, but ticks go on";
    EXPECT_TRUE(std::equal(walk.ticks.begin(), walk.ticks.end(), played.ticks.begin()));
}

}  // namespace
}  // namespace oblong
