#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/folders.h"

// A real window on a display of its own (Xvfb), looked at from outside: tests/window/look.py says what it checks.
TEST(Window, ASphereIsRoundOnScreenAndTheKeysSpoilAndMendIt) {
    constexpr int kSkipped = 77;
    const std::string command =
        "python3 '" + oblong::test::source_folder() + "/tests/window/look.py' '" + oblong::test::build_folder() + "'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kSkipped) GTEST_SKIP() << "see above for what is missing";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}
