#include "engine/platform/replace_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "engine/base/input_error.h"

namespace oblong::test {

namespace {

std::filesystem::path fresh_folder() {
    const auto folder = std::filesystem::path(testing::TempDir()) / "oblong_replace_file";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

std::vector<std::uint8_t> content_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST(ReplaceFile, NewContentTakesTheOldOnesPlaceAndNothingElseIsLeft) {
    const auto folder = fresh_folder();
    const std::vector<std::uint8_t> before(100, 1), after{2, 0, 3};
    replace_file((folder / "file").string(), before);
    replace_file((folder / "file").string(), after);
    EXPECT_EQ(content_of(folder / "file"), after);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(ReplaceFile, WhatFailsLeavesTheOldFile) {
    const auto folder = fresh_folder();
    const std::vector<std::uint8_t> before{1, 2, 3}, after(1 << 16, 4);
    replace_file((folder / "file").string(), before);
    // The unfinished file is a link to a device that is always full.
    std::filesystem::create_symlink("/dev/full", folder / "file.part");
    EXPECT_THROW(replace_file((folder / "file").string(), after), InputError);
    EXPECT_EQ(content_of(folder / "file"), before);
    EXPECT_FALSE(std::filesystem::is_symlink(folder / "file.part"));
}

TEST(ReplaceFile, ADeviceIsWrittenToAndStays) {
    const std::vector<std::uint8_t> bytes(1 << 16, 5);
    EXPECT_THROW(replace_file("/dev/full", bytes), InputError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace oblong::test
