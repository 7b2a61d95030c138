#include "tests/bad_input/run_program.h"

// oblong-render against files and arguments that it must refuse: each names the file and what is wrong with it.
namespace oblong::test {
namespace {

const std::string kProgram = "oblong-render";
const std::string kCameras = "x,y,z,yaw,pitch\n0,-368,54,90,0\n";
const std::string kLevel = OBLONG_BUILD_DIR "/assets/demo.bsp";

class BadRender : public testing::Test {
  protected:
    Outcome render(const std::string& level, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{kProgram, level, "--cameras", folder_.write("cameras.csv", kCameras)};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    }
    TemporaryFolder folder_;
};

TEST_F(BadRender, GoodInputIsNotRefused) {
    const Outcome outcome = render(kLevel, {"--json", folder_.path("a.json"), "--out", folder_.path("pictures")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_TRUE(std::filesystem::exists(folder_.path("pictures/00000.png")));
}

TEST_F(BadRender, WhatIsNoLevel) {
    const std::string missing = folder_.path("missing.bsp"), empty = folder_.write("empty.bsp", std::string()),
                      text = folder_.write("text.bsp", std::string("a level, I said\n"));
    EXPECT_TRUE(names_fault(render(missing), kProgram, missing, "expected a readable file"));
    EXPECT_TRUE(names_fault(render(folder_.path("")), kProgram, folder_.path(""), "is a folder"));
    EXPECT_TRUE(names_fault(render(empty), kProgram, empty, "expected"));
    EXPECT_TRUE(names_fault(render(text), kProgram, text, "expected"));
}

TEST_F(BadRender, PictureNamedLevel) {
    ASSERT_EQ(render(kLevel, {"--out", folder_.path("")}).exit_code, 0);
    const std::string picture = folder_.path("picture.bsp");
    std::filesystem::rename(folder_.path("00000.png"), picture);
    EXPECT_TRUE(names_fault(render(picture), kProgram, picture, "version"));
}

TEST_F(BadRender, Palettes) {
    const std::string missing = folder_.path("missing.lmp");
    EXPECT_TRUE(names_fault(render(kLevel, {"--palette", missing}), kProgram, missing, "expected a readable file"));
    for (const std::size_t size : {0u, 767u, 769u, 3u}) {
        const std::string path = folder_.write("wrong.lmp", Bytes(size));
        EXPECT_TRUE(names_fault(render(kLevel, {"--palette", path}), kProgram, path,
                                std::to_string(size) + " bytes, expected 256"))
            << size;
    }
}

TEST_F(BadRender, CameraLists) {
    struct Case {
        const char *text, *where;
    };
    const Case cases[] = {
        {"", "line 1"},
        {"x,y,z,yaw\n0,0,0,0\n", "no column 'pitch'"},
        {"x,y,z,yaw,pitch,x\n0,0,0,0,0,0\n", "column 'x'"},
        {"x,y,z,yaw,pitch,zoom\n0,0,0,0,0,0\n", "column 'zoom'"},
        {"x,y,z,yaw,pitch\n", "no camera"},
        {"x,y,z,yaw,pitch\n0,0,0,0\n", "line 2: 4 fields"},
        {"x,y,z,yaw,pitch\n0,0,0,0,0\n0,nan,0,0,0\n", "line 3"},
        {"x,y,z,yaw,pitch\n0,0,inf,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,1e3,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,12 apples,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n32769,0,0,0,0\n", "line 2: a coordinate beyond"},
        {"x,y,z,yaw,pitch\n99999999999999999999999,0,0,0,0\n", "line 2"},
    };
    for (const Case& each : cases) {
        const std::string path = folder_.write("bad.csv", std::string(each.text));
        EXPECT_TRUE(names_fault(run_program({kProgram, kLevel, "--cameras", path}), kProgram, path, each.where))
            << each.text;
    }
}

TEST_F(BadRender, PlacesThatCannotBeWritten) {
    const std::string file = folder_.write("file", std::string("in the way"));
    EXPECT_TRUE(names_fault(render(kLevel, {"--json", "/dev/full"}), kProgram, "/dev/full", "No space left"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    EXPECT_TRUE(names_fault(render(kLevel, {"--json", folder_.path("no/such/a.json")}), kProgram,
                            folder_.path("no/such/a.json"), "No such file or directory"));
    EXPECT_TRUE(names_fault(render(kLevel, {"--out", file}), kProgram, file, "make folder"));
    EXPECT_TRUE(names_fault(render(kLevel, {"--out", file + "/below"}), kProgram, file + "/below", "make folder"));
}

TEST_F(BadRender, WrongUsageExitsWith2) {
    const std::vector<std::vector<std::string>> wrong = {{"--zoom", "2"},
                                                         {"--mode", "320"},
                                                         {"--mode", "0x200"},
                                                         {"--mode", "320x200x8"},
                                                         {"--mode", "-320x200"},
                                                         {"--mode", "9999x200"},
                                                         {"--display", "4"},
                                                         {"--display", "4:0"},
                                                         {"--fov", "0"},
                                                         {"--fov", "180"},
                                                         {"--fov", "nan"},
                                                         {"--fov", "-90"},
                                                         {"--accuracy", "2001"},
                                                         {"--repeat", "0"},
                                                         {"--repeat", "x"},
                                                         {"--effects", "smoke"},
                                                         {"--texel-error", "-1"},
                                                         {"--threads", "0"},
                                                         {"--texel-error", "a lot"},
                                                         {"--time", "noon"},
                                                         {"more.bsp"}};
    for (const auto& more : wrong) {
        const Outcome outcome = render(kLevel, more);
        EXPECT_EQ(outcome.exit_code, 2) << more[0] << ' ' << more.back() << ": " << outcome.error;
        EXPECT_NE(outcome.error, "") << more[0] << ' ' << more.back();
    }
    EXPECT_EQ(run_program({kProgram}).exit_code, 2);
    EXPECT_EQ(run_program({kProgram, kLevel}).exit_code, 2);
}

TEST(Programs, HelpAndVersionExitWith0) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(OBLONG_BUILD_DIR "/bin")) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("oblong")) continue;
        ++count;
        EXPECT_EQ(run_program({name, "--help"}).exit_code, 0) << name;
        EXPECT_EQ(run_program({name, "--version"}).exit_code, 0) << name;
        EXPECT_EQ(run_program({name, "--no-such-option"}).exit_code, 2) << name;
    }
    EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace oblong::test
