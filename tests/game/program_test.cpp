#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/io/files.h"
#include "tests/support/programs.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// Runs the game as a user would, in a folder of its own; what it ends with. What is said on standard error goes to
// `error_`.
class Program : public testing::Test {
  protected:
    int run(const std::string& arguments) {
        const std::string line =
            "cd '" + folder_.string() + "' && " + test::at_home_in(folder_) + test::program("oblong") + " " + arguments;
        const auto [exit_code, error] = test::run_line(line, folder_ / "out.txt");
        error_ = error;
        return exit_code;
    }

    const test::TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
    std::string error_;
};

TEST_F(Program, HeadlessWritesAPictureATick) {
    ASSERT_EQ(run("--headless 12 --out walk"), 0) << error_;
    for (int frame = 0; frame < 12; ++frame) {
        const std::string number = std::to_string(frame);
        const auto bytes =
            test::read_file_bytes(folder_ / "walk" / (std::string(5 - number.size(), '0') + number + ".png"));
        ASSERT_GT(bytes.size(), 1000u);
        EXPECT_EQ((std::vector<std::uint8_t>(bytes.begin() + 16, bytes.begin() + 26)),
                  (std::vector<std::uint8_t>{0, 0, 1, 64, 0, 0, 0, 200, 8, 3}));  // 320x200, 8 bits, indexed
    }
    EXPECT_FALSE(fs::exists(folder_ / "walk" / "00012.png"));
    EXPECT_NE(test::read_file_bytes(folder_ / "walk" / "00000.png"),
              test::read_file_bytes(folder_ / "walk" / "00011.png"));
}

// The display is the window's business: the picture itself is another only for another projection.
TEST_F(Program, AspectOptionsSetTheStart) {
    ASSERT_EQ(run("--headless 1 --out usual"), 0) << error_;
    ASSERT_EQ(run("--headless 1 --out squeezed --aspect-projection square"), 0) << error_;
    ASSERT_EQ(run("--headless 1 --out shown --aspect-display square --aspect-projection display"), 0);
    const auto picture = [&](const char* name) { return test::read_file_bytes(folder_ / name / "00000.png"); };
    EXPECT_NE(picture("squeezed"), picture("usual"));
    EXPECT_EQ(picture("shown"), picture("usual"));
}

TEST_F(Program, AReplayShowsWhatWasRecorded) {
    ASSERT_EQ(run("--headless 60 --out live --record walk.demo"), 0) << error_;
    ASSERT_EQ(run("--headless 60 --out again --replay walk.demo --machine 386"), 0) << error_;
    for (const char* name : {"00000.png", "00030.png", "00059.png"})
        EXPECT_EQ(test::read_file_bytes(folder_ / "live" / name), test::read_file_bytes(folder_ / "again" / name))
            << name;
    ASSERT_EQ(run("--timedemo walk.demo"), 0) << error_;
    const std::string said = read_text(folder_ / "out.txt");
    EXPECT_EQ(said.rfind("60 frames, ", 0), 0u) << said;
}

TEST_F(Program, ADemoThatCannotBeKeptIsNotPlayed) {
    for (const char* file : {"no/such/walk.demo", "."}) {
        EXPECT_EQ(run(std::string("--headless 3 --out walk --record ") + file), 1);
        EXPECT_EQ(error_.rfind(std::string("oblong: ") + file + ": write: ", 0), 0u) << error_;
        EXPECT_FALSE(fs::exists(folder_ / "walk")) << file;
    }
}

// It prints nine lines a second.
TEST_F(Program, GoesOnWithoutAReaderAndSavesWhenItsTerminalIsClosed) {
    const std::string line = "cd '" + folder_.string() + "' && mkfifo said && { " + test::at_home_in(folder_) +
                             "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy exec timeout 300 " + test::program("oblong") +
                             " '" + test::build_folder() + "/assets/demo.bsp' --log matrices >said 2>&1 & } && " +
                             "head -45 <said >/dev/null && sleep 2 && kill -HUP $! && wait $!";
    EXPECT_EQ(test::run_line(line).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "oblong" / "auto1.save"));
}

TEST_F(Program, EndsWith2ForWrongUsageAnd1ForBadFiles) {
    // What single options refuse: tests/preferences.
    for (const char* wrong :
         {"--fov 0", "--log clips", "--mode 0x0", "--window 0x9", "--window 800", "''", "--fov ''", "--timedemo ''",
          "--headless 5", "--out here", "--nonsense", "a b", "--replay -", "--timedemo -", "--headless 1 --out -"})
        EXPECT_EQ(run(wrong), 2) << wrong;
    for (const char* wrong : {"--log clip --timedemo a.demo", "--log clip --route a.csv --record b.demo",
                              "--mode 64x48 --fov 179", "--route a.csv --record b.demo --replay c.demo"})
        EXPECT_EQ(run(wrong), 2) << wrong;
    for (const char* frames : {"-1", "0", "1.5"})
        EXPECT_EQ(run("--headless " + std::string(frames) + " --out x"), 2) << frames;
    for (const std::string wrong :
         {"--record ''", "--record -", "--threads 0", "--gallery a", "--gallery --map a", "--gallery --game .",
          "--watch a.map --map b", "--replay walk.demo --record walk.demo", "out.txt --record ./out.txt"})
        EXPECT_EQ(run(wrong + " --headless 1 --out x"), 2) << wrong;
    for (const char* bad :
         {"missing.bsp", ".", "--palette missing.lmp --headless 1 --out x",
          "--replay missing.demo --headless 1 --out x", "--timedemo out.txt", "--headless 1 --out out.txt"}) {
        EXPECT_EQ(run(bad), 1) << bad;
        EXPECT_EQ(error_.rfind("oblong: ", 0), 0u) << error_;
    }
}

}  // namespace
}  // namespace oblong
