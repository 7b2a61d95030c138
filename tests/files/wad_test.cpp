#include "engine/io/wad.h"

#include <gtest/gtest.h>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

MipTexture texture_of(const std::string& name, std::int32_t width, std::int32_t height) {
    MipTexture texture{name, width, height, {}};
    for (std::size_t level = 0; level < 4; ++level) {
        const int count = (width >> level) * (height >> level);
        for (int i = 0; i < count; ++i)
            texture.mips[level].push_back(static_cast<std::uint8_t>(i * 7 + static_cast<int>(level)));
    }
    return texture;
}

TEST(Wad, TexturesComeBackInTheirOrder) {
    const std::vector<MipTexture> textures{texture_of("wall", 16, 32), texture_of("*Water", 64, 16)};
    const auto file = write_wad(textures);
    const auto read = read_wad(file);
    ASSERT_EQ(read.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read[i].name, textures[i].name);
        EXPECT_EQ(parse_miptex(read[i].miptex), textures[i]);
    }
    EXPECT_EQ(lower_case(read[1].name), "*water");
}

// As the format's description has it, byte by byte.
TEST(Wad, HeaderAndDirectoryStandWhereQuakeLooksForThem) {
    const MipTexture texture = texture_of("wall", 16, 16);
    const auto file = write_wad(std::span(&texture, 1));
    const std::size_t lump_size = 40 + 256 + 64 + 16 + 4;
    ASSERT_EQ(file.size(), 12 + lump_size + 32);
    EXPECT_EQ(std::string(file.begin(), file.begin() + 12), std::string("WAD2\1\0\0\0\x88\1\0\0", 12));
    const std::string entry(file.end() - 32, file.end());
    EXPECT_EQ(entry, std::string("\x0c\0\0\0\x7c\1\0\0\x7c\1\0\0D\0\0\0wall\0\0\0\0\0\0\0\0\0\0\0\0", 32));
}

TEST(Wad, NoPrefixIsTakenForAWhole) {
    const MipTexture texture = texture_of("wall", 16, 16);
    const auto whole = write_wad(std::span(&texture, 1));
    expect_no_prefix_is_read(whole,
                             [](std::span<const std::uint8_t> part) { return refusal([&] { read_wad(part); }); });
    expect_no_prefix_is_read(read_wad(whole)[0].miptex,
                             [](std::span<const std::uint8_t> part) { return refusal([&] { parse_miptex(part); }); });
}

// The size in bytes of so many entries is 32 in 32 bits.
TEST(Wad, MoreEntriesThanTheFileHoldsAreRefused) {
    const MipTexture texture = texture_of("wall", 16, 16);
    auto file = write_wad(std::span(&texture, 1));
    file[7] = 8;
    EXPECT_EQ(refusal([&] { read_wad(file); }), "directory: 134217729 entries, expected at most 13 of 32 bytes each");
}

// 30,000 entries for one of 350 KB: a megabyte would be ten gigabytes.
TEST(Wad, EntriesShareTheirTextureOnlyAFewTimes) {
    const MipTexture texture = texture_of("wall", 64, 64);
    auto file = write_wad(std::span(&texture, 1));
    const std::vector<std::uint8_t> entry(file.end() - 32, file.end());
    for (std::uint8_t entries = 2; entries <= 5; ++entries) {
        file.insert(file.end(), entry.begin(), entry.end());
        file[4] = entries;
        if (entries < 5) {
            EXPECT_EQ(read_wad(file).size(), entries);
        }
    }
    EXPECT_TRUE(refusal([&] { read_wad(file); }).starts_with("directory: textures of "));
}

// Mip levels that begin in the header, and widths that no texture has.
TEST(Wad, OddTexturesAreRefused) {
    const MipTexture texture = texture_of("wall", 16, 16);
    const auto expect_refused = [&](int at, int bytes, int value) {
        auto file = write_wad(std::span(&texture, 1));
        std::fill_n(file.begin() + 12 + at, bytes, static_cast<std::uint8_t>(value));
        EXPECT_THROW(parse_miptex(read_wad(file)[0].miptex), InputError) << at << ": " << value;
    };
    for (const int at : {24, 28, 32, 36}) expect_refused(at, 4, 0);
    for (const int width : {0, 8, 24, 255}) expect_refused(16, 1, width);
}

}  // namespace
}  // namespace oblong::test
