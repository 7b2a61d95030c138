#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/programs.h"

namespace oblong {
namespace {

struct Played : test::Outcome {
    std::vector<std::uint8_t> played;  ///< what SDL's driver "disk" wrote instead of playing it
};

// The game for some seconds, in a window that nobody sees, until it is asked to end.
Played run_game_for(int seconds, const std::string& driver, const std::string& arguments) {
    const test::TemporaryFolder folder;
    const std::string line = "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=" + driver + " SDL_DISKAUDIOFILE='" +
                             folder.path("played") + "' " + test::at_home_in(folder.path()) +
                             "timeout --preserve-status -s TERM " + std::to_string(seconds) + " " +
                             test::program("oblong") + " --frame-cap 20 --window 320x240 " + arguments;
    return {test::run_line(line), test::read_file_bytes(folder.path("played"))};
}

// For longer and longer, where a busy machine has not played enough of it by then: up to four minutes at a time.
Played run_game(const std::string& driver, std::size_t least_played_bytes, const std::string& arguments) {
    Played outcome;
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
    const Played outcome = run_game("nonsense", 0, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.error, "oblong: no sound: Audio target 'nonsense' not available\n");
}

TEST(ProgramSound, PlaysMusicOnTheTitle) {
    const Played outcome = run_game("disk", 44'100, "--title");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_GE(outcome.played.size(), 44'100u);
    EXPECT_GT(loudness(outcome.played), 100);
}

TEST(ProgramSound, OpensNoDeviceAtVolume0) {
    const Played outcome = run_game("disk", 0, "--title --volume 0");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.played.empty());
    EXPECT_EQ(outcome.error, "");
}

}  // namespace
}  // namespace oblong
