// The program's answers to wrong usage and bad input, all before it measures anything.

#include "tests/support/bsp_writer.h"
#include "tests/support/programs.h"

namespace oblong::test {
namespace {

TEST(AccuracyProgram, RefusesALevelWithoutCamerasAndCamerasWithoutALevel) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"oblong-accuracy", "level.bsp"},
                                                  {"oblong-accuracy", "--cameras", "cameras.csv"},
                                                  {"oblong-accuracy", "--palette", "palette.lmp"},
                                                  {"oblong-accuracy", "--out", ""},
                                                  {"oblong-accuracy", "--slow"}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.exit_code, 2) << words.back();
        EXPECT_NE(outcome.error, "");
    }
}

TEST(AccuracyProgram, NamesTheFileThatItCannotRead) {
    const TemporaryFolder folder;
    const std::string no_level = folder.write("no_level.bsp", std::string("text")),
                      cameras = folder.write("cameras.csv", std::string("x,y,z,yaw,pitch\n0,0,0,0,0\n"));
    for (const std::string& level : {no_level, folder.path("missing.bsp")}) {
        const Outcome outcome =
            run_program({"oblong-accuracy", "--quick", "--out", folder.path("out"), level, "--cameras", cameras});
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.error.find("oblong-accuracy: " + level + ": "), 0u) << outcome.error;
    }
}

/// The tiny level's floor is at z = 8, solid below.
TEST(AccuracyProgram, NamesTheCameraThatIsInAWall) {
    const TemporaryFolder folder;
    const std::string level = folder.write("tiny.bsp", join_lumps(29, make_tiny_lumps())),
                      cameras = folder.write("cameras.csv", std::string("x,y,z,yaw,pitch\n9,9,50,0,0\n9,9,0,0,0\n"));
    const Outcome outcome =
        run_program({"oblong-accuracy", "--quick", "--out", folder.path("out"), level, "--cameras", cameras});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.error.find("oblong-accuracy: " + level + ": camera 2: in a wall"), 0u) << outcome.error;
}

TEST(AccuracyProgram, NamesTheFolderThatItCannotMake) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", std::string("text"));
    const Outcome outcome = run_program({"oblong-accuracy", "--quick", "--out", file + "/out"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.error.find("oblong-accuracy: " + file), 0u) << outcome.error;
}

}  // namespace
}  // namespace oblong::test
