#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/folders.h"

/// The real levels stand in a folder beside the project (or where the environment's OBLONG_SHARED says); they are
/// never part of it, so tests that need them skip where they are missing.
namespace oblong::test {

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
