#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

/// The real levels stand in a folder beside the project (or where the environment's OBLONG_SHARED says); they are
/// never part of it, so tests that need them skip where they are missing.

namespace oblong::test {

/// The project's folder, and the one that it is built in; absolute, without a slash at the end. Functions and not
/// definitions for the compiler: so that a test's object file is the same wherever the project stands, and a compiler
/// cache has it for every checkout.
std::string source_folder();
std::string build_folder();

/// A folder of its own for one test, gone with it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "oblong-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path() const { return path_.string(); }
    std::string path(const std::string& name) const { return (path_ / name).string(); }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, std::span<const std::uint8_t> bytes) const {
        std::ofstream out(path(name), std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }
    std::string write(const std::string& name, const std::string& text) const {
        return write(name, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }

  private:
    std::filesystem::path path_;
};

/// /dev/null, zero or full for tests of writing. For root it is another node of the device, in a folder of the test: a
/// fault would replace the system's, for everybody. Nobody else can do that.
inline std::string device_for_writing(const std::string& folder, const std::string& name) {
    const unsigned number = name == "null" ? 3 : name == "zero" ? 5 : 7;
    if (geteuid() != 0) return "/dev/" + name;
    const std::string node = folder + "/" + name;
    EXPECT_EQ(mknod(node.c_str(), S_IFCHR | 0666, makedev(1, number)), 0) << node;
    return node;
}

inline constexpr std::array<const char*, 3> kRealLevels = {"dm4", "e1m7", "end"};

/// The folder with levels/ in it; empty if there is none.
inline std::filesystem::path find_shared_folder() {
    std::vector<std::filesystem::path> places = {std::filesystem::path(test::source_folder()) / ".." / "shared"};
    if (const char* named = std::getenv("OBLONG_SHARED")) places.emplace_back(named);
    for (const auto& place : places)
        if (std::filesystem::is_directory(place / "levels")) return place;
    return {};
}

/// All bytes of a file; empty if it cannot be read.
inline std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    return {bytes.begin(), bytes.end()};
}

/// The bytes of levels/NAME under the shared folder, such as "dm4.bsp" or "gfx/palette.lmp".
inline std::vector<std::uint8_t> read_shared_file(const std::string& name) {
    return read_file_bytes(find_shared_folder() / "levels" / name);
}

}  // namespace oblong::test

/// First line of a test that needs the real levels.
#define OBLONG_NEEDS_SHARED_LEVELS()                \
    if (oblong::test::find_shared_folder().empty()) \
    GTEST_SKIP() << "no folder shared/ beside the project, and no OBLONG_SHARED in the environment"
