#include <gtest/gtest.h>

#include "tests/architecture/include_check.h"

// The checker itself, on projects that do not exist.
namespace oblong::test {
namespace {

using Lines = std::vector<std::string>;

/// As many faults as parts, each with its part in it.
testing::AssertionResult are_about(const Lines& faults, const Lines& parts) {
    bool is_alike = faults.size() == parts.size();
    for (std::size_t i = 0; is_alike && i < parts.size(); ++i) is_alike = faults[i].find(parts[i]) != std::string::npos;
    if (is_alike) return testing::AssertionSuccess();
    testing::AssertionResult result = testing::AssertionFailure() << faults.size() << " faults:";
    for (const std::string& fault : faults) result << "\n" << fault;
    return result;
}

const std::vector<Room> kHouse = {{"engine/base", {}},
                                  {"engine/math", {"engine/base"}},
                                  {"engine/frame", {"engine/math"}},
                                  {"engine/files", {"engine/frame"}},
                                  {"game", {"engine/frame"}}};

Lines faults_of(const std::string& path, const std::string& text) {
    return find_bad_includes(kHouse, {{path, text}});
}

TEST(IncludeChecker, DownwardsAndInsideARoomAreAllowed) {
    EXPECT_TRUE(are_about(
        faults_of("game/a.cpp", "#include \"engine/base/x.h\"\n#include \"game/a.h\"\n#include <vector>\n"), {}));
}

TEST(IncludeChecker, UpwardsIsCaughtHoweverItIsSpaced) {
    for (const char* line : {"#include \"game/a.h\"", "  #  include   \"game/a.h\" // why", "#include\"game/a.h\""})
        EXPECT_TRUE(are_about(faults_of("engine/math/v.h", line), {"engine/math does not depend on game"})) << line;
}

TEST(IncludeChecker, SidewaysIsCaught) {
    const std::vector<Room> rooms = {{"a", {}}, {"b", {}}};
    EXPECT_TRUE(are_about(find_bad_includes(rooms, {{"a/x.cpp", "#include \"b/y.h\""}}), {"a/x.cpp"}));
}

TEST(IncludeChecker, PathsNotFromTheRootAreCaught) {
    EXPECT_TRUE(are_about(faults_of("engine/math/v.cpp", "#include \"v.h\"\n#include \"../base/x.h\""),
                          {"v.h", "../base/x.h"}));
}

TEST(IncludeChecker, FilesInNoRoomAreCaught) {
    EXPECT_TRUE(are_about(faults_of("engine/attic/v.cpp", ""), {"in no room"}));
}

TEST(IncludeChecker, SdlHasOneDoor) {
    const std::vector<Room>& rooms = project_rooms();
    for (const char* line : {"#include <SDL.h>", "#include <SDL2/SDL.h>", "#include \"SDL_audio.h\""}) {
        EXPECT_TRUE(are_about(find_bad_includes(rooms, {{"engine/platform/sdl/window.cpp", line}}), {})) << line;
        EXPECT_TRUE(
            are_about(find_bad_includes(rooms, {{"engine/platform/platform.h", line}, {"game/program/main.cpp", line}}),
                      {"only engine/platform/sdl/", "only engine/platform/sdl/"}));
    }
}

TEST(IncludeChecker, EngineHasNoFilesClockThreadsOrRandomness) {
    for (const char* line : {"#include <fstream>", "#include <chrono>", "#include <thread>", "#include <random>",
                             "#include <format>", "#include <ranges>", "#include <source_location>"}) {
        EXPECT_TRUE(are_about(faults_of("engine/frame/f.cpp", line), {"does without it"})) << line;
        EXPECT_TRUE(are_about(faults_of("game/program/main.cpp", line), {})) << line;
        EXPECT_TRUE(are_about(faults_of("engine/files/files.cpp", line), {})) << line;
    }
}

TEST(IncludeChecker, TextThatIsNoIncludeIsNone) {
    EXPECT_TRUE(are_about(faults_of("engine/math/v.h", "// #include \"game/a.h\"\n#define include <game>\n#\n"), {}));
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
