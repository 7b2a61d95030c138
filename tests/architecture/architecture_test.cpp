#include <gtest/gtest.h>
#include <stdio.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/architecture/include_check.h"
#include "tests/architecture/unused_check.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::source_folder();

std::string read_text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<SourceFile> read_sources() {
    std::vector<SourceFile> files;
    for (const char* top : {"engine", "game", "tools"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
            const fs::path kind = entry.path().extension();
            if (kind != ".h" && kind != ".cpp") continue;
            files.push_back({fs::relative(entry.path(), kRoot).generic_string(), read_text(entry.path())});
        }
    return files;
}

/// What git keeps of the project, or would keep if it were added; empty where there is no repository.
std::vector<std::string> list_repository() {
    const std::string command = "git -C '" + kRoot.string() + "' ls-files 2>/dev/null";
    std::vector<std::string> paths;
    FILE* const pipe = popen(command.c_str(), "r");
    if (!pipe) return paths;
    for (char line[4096]; fgets(line, sizeof line, pipe);) {
        paths.emplace_back(line);
        paths.back().pop_back();
    }
    pclose(pipe);
    return paths;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(Architecture, EveryIncludePointsDown) {
    const std::vector<SourceFile> files = read_sources();
    ASSERT_GT(files.size(), 100u);
    EXPECT_EQ(joined(find_bad_includes(project_rooms(), files)), "");
}

TEST(Architecture, NoFunctionOfTheEngineIsForTestsAlone) {
    std::vector<SourceFile> files = read_sources();
    // What can't be seen otherwise: that a voice has ended, and which parts of the depth buffer are set.
    files.push_back({"game/seen.cpp", "is_playing, rectangles"});
    EXPECT_EQ(joined(find_unused_functions(files)), "");
}

// But for what the game links of the engine and the tools, and for the game for DOS, which is a project of its own.
TEST(Architecture, CMakeLinksTheEngineAndTheGameByTheSameList) {
    for (const std::string top : {"engine/", "game/"}) {
        const auto of_top = [&](Room room) {
            std::erase_if(room.depends, [&](const std::string& folder) { return !folder.starts_with(top); });
            return room;
        };
        std::vector<Room> listed;
        for (const Room& room : project_rooms())
            if (room.folder.starts_with(top) && room.folder != "game/dos" && room.folder != "game/web")
                listed.push_back(of_top(room));
        const std::vector<Room> linked = parse_cmake_rooms(read_text(kRoot / top / "CMakeLists.txt"), top);
        ASSERT_EQ(linked.size(), listed.size());
        for (std::size_t i = 0; i < linked.size(); ++i) EXPECT_EQ(of_top(linked[i]), listed[i]) << linked[i].folder;
    }
}

// What the oldest library lacks that the project is compiled with: LLVM 13's, by Debian's WebAssembly compiler.
TEST(Architecture, NoSourceAsksForMoreThanTheOldestLibraryHas) {
    for (const SourceFile& file : read_sources())
        for (const char* lacking : {"std::ranges::", "std::views::", "std::bit_cast<", "make_unique_for_overwrite",
                                    "std::format(", "std::source_location", "std::jthread"})
            EXPECT_EQ(file.text.find(lacking), std::string::npos) << file.path << ": " << lacking;
}

TEST(Architecture, TopLevelHoldsOnlyWhatIsNamed) {
    const std::vector<std::string> paths = list_repository();
    if (paths.empty()) GTEST_SKIP() << "the project's folder is not a git repository";
    EXPECT_EQ(joined(find_strays(paths)), "");
}

}  // namespace
}  // namespace oblong::test
