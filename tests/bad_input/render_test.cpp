#include <map>
#include <sstream>

#include "tests/support/folders.h"
#include "tests/support/programs.h"

namespace oblong::test::render_test {
namespace {

// oblong-render against files and arguments that it must refuse: each names the file and what is wrong with it.

const std::string kProgram = "oblong-render";
const std::string kCameras = "x,y,z,yaw,pitch\n0,-368,54,90,0\n";
const std::string kLevel = test::build_folder() + "/assets/demo.bsp";

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
    EXPECT_NE(render(kLevel, {"--json", "-", "--plan"}).error.find("sky"), std::string::npos) << "no plan";
}

TEST_F(BadRender, AReportOverWhatIsRead) {
    for (const char* name : {"cameras.csv", "its.lmp", "level.bsp"}) {
        folder_.write("its.lmp", std::vector<std::uint8_t>(768));
        folder_.write("level.bsp", read_file_bytes(kLevel));
        const std::string file = folder_.path(name);
        const Outcome outcome =
            render(folder_.path("level.bsp"), {"--palette", folder_.path("./its.lmp"), "--json", file});
        EXPECT_EQ(outcome.exit_code, 2) << name;
        EXPECT_NE(outcome.error.find("'" + file + "' is read or written for another option"), std::string::npos);
        EXPECT_NE(read_file_bytes(file).front(), '{') << name;
    }
}

TEST_F(BadRender, WhatIsNoLevel) {
    const std::string missing = folder_.path("missing.bsp"), empty = folder_.write("empty.bsp", std::string()),
                      text = folder_.write("text.bsp", std::string("a level, I said\n"));
    EXPECT_TRUE(names_fault(render(missing), kProgram, missing, "expected a readable file"));
    EXPECT_TRUE(names_fault(render(folder_.path("")), kProgram, folder_.path(""), "is a folder"));
    EXPECT_TRUE(names_fault(render(empty), kProgram, empty, "expected"));
    EXPECT_TRUE(names_fault(render(text), kProgram, text, "expected"));
}

/// Models that the demo level shows, from a folder that comes before its own.
TEST_F(BadRender, Models) {
    const std::string missing = folder_.path("missing"), headless = folder_.path("pictures");
    EXPECT_TRUE(names_fault(render(kLevel, {"--models", missing}), kProgram, missing, "--models: is no folder"));
    EXPECT_TRUE(names_fault(run_program({"oblong", "--models", missing, "--headless", "1", "--out", headless}),
                            "oblong", missing, "--models: is no folder"));
    std::filesystem::create_directory(folder_.path("models"));
    const std::string model = "models/armillary.obj";
    const std::pair<std::string, std::string> cases[] = {{"", "file: has no faces, expected"},
                                                         {"v 0 0 nan\n", "line 1: vertex 'nan', expected a number"},
                                                         {"v 0 0 0\nf 1 2 3\n", "line 2: vertex 3, expected 1"},
                                                         {"\x89PNG\r\n", "file: has no faces, expected"}};
    for (const auto& [text, where] : cases) {
        const std::string file = folder_.write(model, text);
        EXPECT_TRUE(names_fault(render(kLevel, {"--models", folder_.path("")}), kProgram, file, where)) << text;
    }
    folder_.write(model, std::string("mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    const Outcome warned = render(kLevel, {"--models", folder_.path("")});
    EXPECT_EQ(warned.exit_code, 0);
    EXPECT_NE(warned.error.find("warning: "), std::string::npos);
    EXPECT_NE(warned.error.find("none.mtl"), std::string::npos) << warned.error;
}

TEST_F(BadRender, Palettes) {
    const std::string missing = folder_.path("missing.lmp");
    EXPECT_TRUE(names_fault(render(kLevel, {"--palette", missing}), kProgram, missing, "expected a readable file"));
    for (const std::size_t size : {0u, 767u, 769u, 3u}) {
        const std::string path = folder_.write("wrong.lmp", std::vector<std::uint8_t>(size));
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
        {"", "line 1: is empty"},
        {"\n0,0,0,0,0\n", "line 1: is empty"},
        {"x;y;z;yaw;pitch\n0;0;0;0;0\n", "column 'x;y;z;yaw;pitch'"},
        {"x,y,z,yaw,pitch\r0,0,0,0,zero\r", "line 2: 'zero'"},
        {"\x1b[31mx,y,z,yaw,pitch\n0,0,0,0,0\n", "column '?[31mx'"},
        {"x,y,z,yaw\n0,0,0,0\n", "no column 'pitch'"},
        {"x,y,z,yaw,pitch,x\n0,0,0,0,0,0\n", "column 'x'"},
        {"x,y,z,yaw,pitch,zoom\n0,0,0,0,0,0\n", "column 'zoom'"},
        {"x,y,z,yaw,pitch\n", "no camera"},
        {"x,y,z,yaw,pitch\n0,0,0,0\n", "line 2: 4 fields"},
        {"x,y,z,yaw,pitch\n0,0,0,0,0\n0,nan,0,0,0\n", "line 3"},
        {"x,y,z,yaw,pitch\n0,0,inf,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,1e3,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,0x10,0,0\n", "line 2"},
        {"x,y,z,yaw,pitch\n0,0,1 2,0,0\n", "line 2: '1 2'"},
        {"x,y,z,yaw,pitch\n0,0,1,0,0,\n", "line 2: 6 fields"},
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

// One camera, written as spreadsheets and other programs write it: the same picture.
TEST_F(BadRender, CameraListsOfOtherProgramsAreTaken) {
    const auto picture_of = [&](const std::string& cameras) {
        const Outcome outcome = run_program(
            {kProgram, kLevel, "--cameras", folder_.write("cameras.csv", cameras), "--out", folder_.path("")});
        EXPECT_EQ(outcome.exit_code, 0) << cameras << outcome.error;
        return read_file_bytes(folder_.path("00000.png"));
    };
    const auto expected = picture_of("x,y,z,yaw,pitch\n0.0625,-368,54,90,0\n");
    for (const std::string cameras :
         {"\xef\xbb\xbfx,y,z,yaw,pitch\r\n0.0625,-368,54,90,0\r\n", "x,y,z,yaw,pitch\r0.0625,-368,54,90,0\r",
          "x, y, z, yaw, pitch\n 0.0625, -368, 54, 90, 0", "roll,pitch,yaw,z,y,x\n360,-0,-270,54,-368.0,.0625\n"})
        EXPECT_EQ(picture_of(cameras), expected) << cameras;
}

TEST_F(BadRender, FileNamesOfNoUtf8AreReported) {
    const std::string level = folder_.write("\xff.bsp", read_file_bytes(kLevel));
    const Outcome outcome = render(level, {"--json", folder_.path("a.json")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_GT(std::filesystem::file_size(folder_.path("a.json")), 100u);
}

TEST_F(BadRender, PlacesThatCannotBeWritten) {
    const std::string file = folder_.write("file", std::string("in the way"));
    const std::string full = device_for_writing(folder_.path(), "full");
    EXPECT_TRUE(names_fault(render(kLevel, {"--json", full}), kProgram, full, "No space left"));
    EXPECT_TRUE(std::filesystem::is_character_file(full));
    EXPECT_TRUE(names_fault(render(folder_.path("missing.bsp"), {"--json", folder_.path("no/such/a.json")}), kProgram,
                            folder_.path("no/such/a.json"), "is no folder"))
        << "before anything is drawn";
    EXPECT_TRUE(names_fault(render(kLevel, {"--out", file}), kProgram, file, "make folder"));
    EXPECT_TRUE(names_fault(render(kLevel, {"--out", file + "/below"}), kProgram, file + "/below", "make folder"));
}

TEST_F(BadRender, WrongUsageExitsWith2) {
    const std::map<std::string, std::vector<std::string>> wrong{
        {"--zoom", {"2"}},
        {"--mode", {"320", "0x200", "320x200x8", "-320x200", "9999x200", "8x8 --fov 179", "-"}},
        {"--display", {"4", "4:0"}},
        {"--fov", {"0", "180", "nan", "-90", ""}},
        {"--log", {"clips", "clip,"}},
        {"--brightness", {"0"}},
        {"--accuracy", {"2001"}},
        {"--repeat", {"0", "x"}},
        {"--effects", {"smoke"}},
        {"--hidden-surfaces", {"edge-list", "z-buffer --view isometric"}},
        {"--texel-error", {"-1", "a_lot", "0.5 --accuracy 1991", "0.5 --accuracy exact", ""}},
        {"--view", {"left", "front:", "front:width", "front:width=0", "front:front=5,back=5", "vrp:front=5,back=1"}},
        {"--instructions", {"fastest"}},
        {"--threads", {"0"}},
        {"--time", {"noon", "inf", "-1"}},
        {"--time-step", {"61"}},
        {"--out", {"-", ""}},
        {"--palette", {"-", ""}},
        {"--json", {""}}};
    for (const auto& [option, values] : wrong)
        for (const std::string& value : values) {
            std::vector<std::string> words{option};
            std::istringstream more(value);
            for (std::string word; more >> word;) words.push_back(word);
            if (value.empty()) words.emplace_back();
            const Outcome outcome = render(kLevel, words);
            EXPECT_EQ(outcome.exit_code, 2) << option << ' ' << value << ": " << outcome.error;
            EXPECT_TRUE(outcome.error.starts_with(kProgram + ": ")) << outcome.error;
            EXPECT_NE(outcome.error.find(option), std::string::npos) << outcome.error;
        }
    EXPECT_NE(render(kLevel, {"--time", "-1"}).error.find("expected 0 to 16777216 seconds"), std::string::npos);
    EXPECT_EQ(render(kLevel, {"more.bsp"}).exit_code, 2);
    EXPECT_EQ(run_program({kProgram}).exit_code, 2);
    EXPECT_EQ(run_program({kProgram, kLevel}).exit_code, 2);
}

TEST(Programs, WhatIsWrongIsNamedBeforeWhatIsMissing) {
    struct Case {
        std::vector<std::string> words;
        const char* named;
    };
    for (const auto& [words, named] :
         {Case{{"oblong-render", "--bogus"}, "--bogus"}, Case{{"oblong-texture", "bogus"}, "bogus"},
          Case{{"oblong-texture", "pack", "--bogus"}, "--bogus"},
          Case{{"oblong-map", "-o", "a.bsp", "--bogus"}, "--bogus"}, Case{{"oblong-render"}, "LEVEL"},
          Case{{"oblong-texture", "pack"}, "input is required"}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.error.find(named), std::string::npos) << outcome.error;
    }
}

TEST(Programs, ADashStandsForNoFileThatIsReadOrWritten) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"oblong", "-"},
                                               {"oblong", "--record", "-"},
                                               {"oblong-map", "-", "-o", "a.bsp"},
                                               {"oblong-map", "a.map", "-o", "-"},
                                               {"oblong-render", "-", "--cameras", "a.csv"},
                                               {"oblong-render", "a.bsp", "--cameras", "-"},
                                               {"oblong-texture", "pack", "a.png", "-o", "a.wad", "--palette", "-"},
                                               {"oblong-texture", "unpack", "-", "-o", "a", "--palette", "b"}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.exit_code, 2) << words[0] << ' ' << words[1];
        EXPECT_NE(outcome.error.find("'-' is neither"), std::string::npos) << outcome.error;
    }
}

// What a program says and nobody gets is a failure.
TEST(Programs, StandardOutputThatIsFullIsAFailure) {
    const TemporaryFolder folder;
    const std::string cameras = folder.write("cameras.csv", kCameras);
    for (const std::vector<std::string>& words : {std::vector<std::string>{kProgram, kLevel, "--cameras", cameras},
                                                  {kProgram, "--help"},
                                                  {"oblong-map", "--version"}})
        EXPECT_TRUE(names_fault(run_program(words, "/dev/full"), words[0], "standard output", "write: ")) << words[1];
}

TEST(Programs, StandardInputThatCannotBeReadIsAFailure) {
    EXPECT_TRUE(
        names_fault(run_line("(" + program("oblong-probe") + " </)"), "oblong-probe", "standard input", "read"));
    EXPECT_EQ(run_line(program("oblong-probe")).exit_code, 0);
}

TEST(Programs, HelpAndVersionExitWith0) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::build_folder() + "/bin")) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("oblong")) continue;
        ++count;
        EXPECT_EQ(run_program({name, "--help"}).exit_code, 0) << name;
        EXPECT_EQ(run_program({name, "--version"}).exit_code, 0) << name;
        EXPECT_EQ(run_program({name, "--no-such-option"}).exit_code, 2) << name;
    }
    EXPECT_GE(count, 4);
    EXPECT_EQ(run_program({"oblong-texture"}).exit_code, 2) << "no command";
}

// oblong --route against routes that it must refuse.

const std::string kHeader = "x,y,z,speed,wait,yaw,pitch,jump\n";

class BadRoute : public testing::Test {
  protected:
    Outcome walk(const std::string& route) {
        file_ = folder_.write("route.csv", route);
        return run_program({"oblong", "--route", file_, "--record", folder_.path("walk.demo")});
    }
    TemporaryFolder folder_;
    std::string file_;
};

TEST_F(BadRoute, AWalkIntoAWallIsStuckAndLeavesNoDemo) {
    const Outcome outcome = walk(kHeader + "0,-300,,,,,,\n400,-300,,,,,,\n");
    EXPECT_TRUE(names_fault(outcome, "oblong", file_, "line 3: stuck at 143 -301 24, expected to reach 400 -300"))
        << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("walk.demo")));
}

TEST_F(BadRoute, AByteOrderMarkIsNoPartOfTheHeaderAndOldMacsEndsOfLinesAreTaken) {
    EXPECT_TRUE(names_fault(walk("\xef\xbb\xbf" + kHeader + "here\n"), "oblong", file_, "line 2: "));
    EXPECT_TRUE(names_fault(walk("x,y,z,speed,wait,yaw,pitch,jump\rhere\r"), "oblong", file_, "line 2: "));
}

TEST_F(BadRoute, ThousandsOfUnknownArgumentsAreAShortMessage) {
    std::vector<std::string> arguments{"oblong-map"};
    for (int i = 0; i < 5000; ++i) arguments.push_back("--n" + std::to_string(i));
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_LT(outcome.error.size(), 1200u) << outcome.error.size();
    EXPECT_NE(outcome.error.find("--n"), std::string::npos) << outcome.error;
}

TEST_F(BadRoute, RecordingReplacesOnlyADemo) {
    EXPECT_EQ(walk(kHeader).exit_code, 1);
    const Outcome outcome = run_program({"oblong", "--route", file_, "--record", file_});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.error.find("is there and no demo"), std::string::npos) << outcome.error;
    EXPECT_EQ(read_file_bytes(file_).size(), kHeader.size());
}

TEST_F(BadRoute, WhatIsNoRoute) {
    EXPECT_TRUE(names_fault(walk("where to?\n"), "oblong", file_, "line 1: 'where to?', expected x,y,z"));
    const Outcome alone = run_program({"oblong", "--route", file_});
    EXPECT_EQ(alone.exit_code, 2) << "nothing to record into: " << alone.error;
}

}  // namespace
}  // namespace oblong::test::render_test
