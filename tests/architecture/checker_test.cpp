#include <gtest/gtest.h>

#include <algorithm>

#include "tests/architecture/include_check.h"
#include "tests/architecture/unused_check.h"

// The checker itself, on projects that do not exist.
namespace oblong::test {
namespace {

using Lines = std::vector<std::string>;

/// As many faults as parts, each with its part in it.
testing::AssertionResult are_about(const Lines& faults, const Lines& parts) {
    const auto is_about = [](const std::string& fault, const std::string& part) {
        return fault.find(part) != fault.npos;
    };
    if (std::equal(faults.begin(), faults.end(), parts.begin(), parts.end(), is_about))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << testing::PrintToString(faults);
}

const std::vector<Room> kHouse = {{"engine/base", {}},
                                  {"engine/math", {"engine/base"}},
                                  {"engine/frame", {"engine/math"}},
                                  {"engine/beside", {"engine/math"}},
                                  {"engine/files", {"engine/frame"}},
                                  {"engine/platform", {}},
                                  {"engine/platform/sdl", {"engine/platform"}},
                                  {"game", {"engine/frame"}}};

struct IncludeCase {
    const char *name, *path, *text;
    Lines faults{};
};

TEST(IncludeChecker, FindsWhatBreaksARuleAndNothingElse) {
    const Lines up{"engine/math does not depend on game"}, sdl{"only engine/platform/sdl/"}, without{"does without it"};
    for (const auto& [name, path, text, faults] : std::vector<IncludeCase>{
             {"downwards, and inside a room", "game/a.cpp",
              "#include \"engine/base/x.h\"\n#include \"game/a.h\"\n#include <vector>\n"},
             {"upwards", "engine/math/v.h", "#include \"game/a.h\"", up},
             {"with spaces", "engine/math/v.h", "  #  include   \"game/a.h\" // why", up},
             {"without spaces", "engine/math/v.h", "#include\"game/a.h\"", up},
             {"sideways", "engine/frame/x.cpp", "#include \"engine/beside/y.h\"", {"does not depend on engine/beside"}},
             {"not from the root",
              "engine/math/v.cpp",
              "#include \"v.h\"\n#include \"../base/x.h\"",
              {"v.h", "../base/x.h"}},
             {"in no room", "engine/attic/v.cpp", "", {"in no room"}},
             {"SDL's door", "engine/platform/sdl/window.cpp",
              "#include <SDL.h>\n#include <SDL2/SDL.h>\n#include \"SDL_audio.h\"\n"},
             {"SDL", "engine/platform/platform.h", "#include <SDL.h>", sdl},
             {"SDL of another folder", "game/main.cpp", "#include <SDL2/SDL.h>", sdl},
             {"SDL in quotes", "game/main.cpp", "#include \"SDL_audio.h\"", sdl},
             {"a file in the game", "game/main.cpp", "#include <fstream>\n#include <thread>\n"},
             {"a file in engine/files", "engine/files/files.cpp", "#include <fstream>\n#include <chrono>\n"},
             {"files", "engine/frame/f.cpp", "#include <fstream>", without},
             {"a clock", "engine/frame/f.cpp", "#include <chrono>", without},
             {"threads", "engine/frame/f.cpp", "#include <thread>", without},
             {"randomness", "engine/frame/f.cpp", "#include <random>", without},
             {"what old libraries lack",
              "engine/frame/f.cpp",
              "#include <format>\n#include <ranges>\n#include <source_location>\n",
              {"format", "ranges", "source_location"}},
             {"an example's", "engine/examples/e.cpp", "#include <oblong.h>\n#include <cstdio>\n#include <random>\n"},
             {"an example's of the engine",
              "engine/examples/e.cpp",
              "#include \"engine/base/x.h\"\n#include <SDL.h>\n#include \"oblong.h\"\n",
              {"engine/base/x.h", "SDL.h"}},
             {"no include", "engine/math/v.h", "// #include \"game/a.h\"\n#define include <game>\n#\n"}})
        EXPECT_TRUE(are_about(find_bad_includes(kHouse, {{path, text}}), faults)) << name;
}

TEST(UnusedCheck, CallsCountAndDeclarationsAndDefinitionsDoNot) {
    const std::vector<SourceFile> files = {
        {"engine/a/a.h",
         "int used(int);\nint unused(int);  // unused(1)\nclass A {\n  public:\n    const A* own(int);\n};\n"},
        {"engine/a/a.cpp", "int used(int a) {\n    return a;\n}\nint unused(int);\nconst A* A::own(int) {}\n"},
        {"engine/methods/m.h", "int for_tests(int);\n"},
        {"game/g.cpp", "const int one = 2 * used(1);\nconst char* text = \"unused\";\n"},
        {"tools/gallery/row.cpp", "const int two = unused(2);\n"}};
    EXPECT_TRUE(are_about(find_unused_functions(files), {"engine/a/a.h: own", "engine/a/a.h: unused"}));
}

TEST(Rooms, LongestFolderWins) {
    const std::vector<Room>& rooms = project_rooms();
    EXPECT_EQ(find_room(rooms, "engine/platform/sdl/window.cpp")->folder, "engine/platform/sdl");
    EXPECT_EQ(find_room(rooms, "engine/platform/headless/headless.cpp")->folder, "engine/platform");
    EXPECT_EQ(find_room(rooms, "engine/raster/kernels/plain.cpp")->folder, "engine/raster");
    EXPECT_EQ(find_room(rooms, "engines/a.cpp"), nullptr);
}

TEST(Rooms, CMakeFileIsReadWithItsDepends) {
    const std::string cmake =
        "# words\noblong_room(a x)\nfind_package(Q)\noblong_room(b y/z DEPENDS a EXTRA_FOLDERS y/w)\noblong_room(c c "
        "EXTRA_FOLDERS q DEPENDS a\n b)\n";
    EXPECT_EQ(parse_cmake_rooms(cmake, "e/"),
              (std::vector<Room>{Room{"e/x", {}}, Room{"e/y/z", {"e/x"}}, Room{"e/c", {"e/x", "e/y/z"}}}));
}

TEST(Strays, OnlyWhatIsNamedAndDotFilesStandAtTheTop) {
    EXPECT_EQ(find_strays({"engine/a.h", ".ci/run", ".gitignore", "README.md", "notes.txt", "src/a.cpp", "src/b.cpp"}),
              (Lines{"notes.txt", "src"}));
}

}  // namespace
}  // namespace oblong::test
