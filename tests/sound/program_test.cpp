#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>

#include "engine/files/files.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int exit_code = -1;
    std::string error;                 ///< what it said on standard error
    std::vector<std::uint8_t> played;  ///< what SDL's driver "disk" wrote instead of playing it
};

// The game for some seconds, in a window that nobody sees, until it is asked to end.
Outcome run_game_for(int seconds, const std::string& driver, const std::string& arguments) {
    const test::TemporaryFolder folder;
    const std::string line = "env SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=" + driver + " SDL_DISKAUDIOFILE='" +
                             folder.path("played") + "' XDG_CONFIG_HOME='" + folder.path() + "' XDG_DATA_HOME='" +
                             folder.path() + "' timeout --preserve-status -s TERM " + std::to_string(seconds) + " '" +
                             test::build_folder() + "/bin/oblong' --frame-cap 20 --window 320x240 " + arguments +
                             " 2>'" + folder.path("error") + "'";
    const int status = std::system(line.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder.path("error")), {}};
    if (fs::exists(folder.path("played"))) outcome.played = read_file(folder.path("played"));
    return outcome;
}

// For longer and longer, where a busy machine has not played enough of it by then: up to four minutes at a time.
Outcome run_game(const std::string& driver, std::size_t least_played_bytes, const std::string& arguments) {
    Outcome outcome;
    for (int seconds = 2; seconds < 300; seconds *= 5) {
        outcome = run_game_for(seconds, driver, arguments);
        if (outcome.exit_code == 0 && outcome.played.size() >= least_played_bytes) break;
    }
    return outcome;
}

double loudness(const std::vector<std::uint8_t>& bytes) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        sum += std::pow(static_cast<std::int16_t>(bytes[i] | bytes[i + 1] << 8), 2);
    return std::sqrt(sum / static_cast<double>(bytes.size() / 2));
}

TEST(ProgramSound, GoesOnInSilenceWhereThereIsNoDevice) {
    const Outcome outcome = run_game("nonsense", 0, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.error, "oblong: no sound: Audio target 'nonsense' not available\n");
}

TEST(ProgramSound, PlaysMusicOnTheTitle) {
    const Outcome outcome = run_game("disk", 44'100, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_GE(outcome.played.size(), 44'100u);
    EXPECT_GT(loudness(outcome.played), 100);
}

TEST(ProgramSound, OpensNoDeviceAtVolume0) {
    const Outcome outcome = run_game("disk", 0, "--title --volume 0");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.played.empty());
    EXPECT_EQ(outcome.error, "");
}

}  // namespace
}  // namespace oblong
