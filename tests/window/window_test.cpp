#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "engine/io/files.h"
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

// Whatever SDL_VIDEODRIVER leaves SDL to find: a window that nobody sees is opened by its driver's name alone.
TEST(Window, WithoutADisplayTheGameEndsAndSaysSo) {
    for (const std::string driver : {"-u SDL_VIDEODRIVER", "SDL_VIDEODRIVER=", "SDL_VIDEODRIVER=x11,dummy",
                                     "SDL_VIDEODRIVER=x11,offscreen,dummy", "SDL_VIDEODRIVER=x11"}) {
        const oblong::test::TemporaryFolder folder;
        const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY " + driver + " XDG_CONFIG_HOME='" +
                                    folder.path() + "' XDG_DATA_HOME='" + folder.path() + "' timeout 200 '" +
                                    oblong::test::build_folder() + "/bin/oblong' --volume 0 2>'" +
                                    folder.path("error") + "'";
        const int status = std::system(command.c_str());
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 1) << driver;
        const std::string error = oblong::read_text(folder.path("error"));  // with lines of libraries
        EXPECT_NE(error.find("oblong: no display"), std::string::npos) << driver << ": " << error;
    }
}
