#include <gtest/gtest.h>
#include <stdio.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/architecture/source_checks.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::source_folder();

/// The rooms for machine code, and the system that DOS lacks.
constexpr const char* kMachineRooms[] = {"engine/fixed/native/", "engine/raster/kernels/", "engine/platform/dos/"};

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

// Of each kind of fault one is put among the sources: it alone is found.
TEST(Architecture, EveryIncludePointsDown) {
    std::vector<SourceFile> files = read_sources();
    files.push_back({"engine/math/up.h", "#include \"game/view/hud.h\"\n#include <fstream>\n#include <SDL.h>\n"});
    files.push_back({"game/view/posix.cpp", "#include <sys/stat.h>\n"});
    files.push_back({"engine/examples/inside.cpp", "#include <cmath>\n#include \"engine/math/vec.h\"\n"});
    files.push_back({"engine/attic/a.h", ""});
    EXPECT_EQ(
        joined(find_bad_includes(project_rooms(test::source_folder()), files)),
        "engine/math/up.h: includes game/view/hud.h: engine/math does not depend on game/view\n"
        "engine/math/up.h: includes fstream: the engine does without it, but where it meets a system or files\n"
        "engine/math/up.h: includes SDL.h: only engine/platform/sdl/ includes SDL\n"
        "game/view/posix.cpp: includes sys/stat.h: only engine/io/system.cpp asks the system\n"
        "engine/examples/inside.cpp: includes engine/math/vec.h: an example uses oblong.h and the standard library "
        "alone\n"
        "engine/attic/a.h: in no room\n");
}

TEST(Architecture, NoHeaderIncludesItselfThroughOthers) {
    std::vector<SourceFile> files = read_sources();
    files.push_back({"engine/math/a.h", "#include \"engine/math/b.h\"\n"});
    files.push_back({"engine/math/b.h", "#include \"engine/math/vec.h\"\n#include \"engine/math/a.h\"\n"});
    files.push_back({"engine/math/above.h", "#include \"engine/math/a.h\"\n"});
    EXPECT_EQ(joined(find_include_cycles(files)), "engine/math/a.h\nengine/math/b.h\n");
}

TEST(Architecture, NoFunctionOfTheEngineIsForTestsAlone) {
    std::vector<SourceFile> files = read_sources();
    // What can't be seen otherwise: that a voice has ended, and which parts of the depth buffer are set.
    files.push_back({"game/seen.cpp", "is_playing, rectangles"});
    files.push_back({"engine/math/unused.h", "int asked_for_by_nobody(int);  // asked_for_by_nobody(1)\n"});
    EXPECT_EQ(joined(find_unused_functions(files)),
              "engine/math/unused.h: asked_for_by_nobody is used by no program\n");
}

// What the oldest library lacks that the project is compiled with: LLVM 13's, by Debian's WebAssembly compiler.
TEST(Architecture, NoSourceAsksForMoreThanTheOldestLibraryHas) {
    for (const SourceFile& file : read_sources())
        for (const char* lacking : {"std::ranges::", "std::views::", "std::bit_cast<", "make_unique_for_overwrite",
                                    "std::format(", "std::source_location", "std::jthread"})
            EXPECT_EQ(file.text.find(lacking), std::string::npos) << file.path << ": " << lacking;
}

// Tests of a processor, assembly and intrinsics: the lines of a file outside the rooms for machine code.
std::vector<std::string> find_machine_code(const std::vector<SourceFile>& files) {
    static const std::regex code(
        R"(__(i386|x86_64|aarch64|arm|ARM_NEON|SSE\d?|AVX\w*|BMI2?|ALTIVEC)\w*|_mm\d*_|intrin\.h|gnu::target|\basm\b)");
    std::vector<std::string> found;
    for (const SourceFile& file : files) {
        const bool is_allowed = std::any_of(std::begin(kMachineRooms), std::end(kMachineRooms),
                                            [&](const char* room) { return file.path.starts_with(room); });
        std::istringstream lines(is_allowed ? "" : file.text);
        for (std::string line; std::getline(lines, line);)
            if (std::regex_search(line.substr(0, line.find("//")), code)) found.push_back(file.path + ": " + line);
    }
    return found;
}

TEST(Architecture, MachineCodeStandsBehindItsDoors) {
    std::vector<SourceFile> files = read_sources();
    files.push_back(
        {"engine/math/fast.h", "#if defined(__i386__)  // a test\nasm(\"nop\");\n#include <emmintrin.h>\n// asm\n"});
    EXPECT_EQ(joined(find_machine_code(files)),
              "engine/math/fast.h: #if defined(__i386__)  // a test\n"
              "engine/math/fast.h: asm(\"nop\");\n"
              "engine/math/fast.h: #include <emmintrin.h>\n");
}

TEST(Architecture, TopLevelHoldsOnlyWhatIsNamed) {
    std::vector<std::string> paths = list_repository();
    if (paths.empty()) GTEST_SKIP() << "the project's folder is not a git repository";
    paths.emplace_back("src/a.cpp");
    EXPECT_EQ(joined(find_strays(paths)), "src\n");
}

}  // namespace
}  // namespace oblong::test
