#include "tools/texture/texture_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/platform/files.h"
#include "tests/support/shared_levels.h"
#include "tests/texture/test_palette.h"
#include "tools/png/indexed_png.h"
#include "tools/texture/mipmaps.h"
#include "tools/texture/texture_name.h"
#include "tools/texture/wad.h"

namespace oblong {
namespace {

/// A folder of its own for each test, gone after it.
class TextureFiles : public testing::Test {
  protected:
    TextureFiles() : folder_(std::filesystem::temp_directory_path() / ("oblong-" + test_name())) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~TextureFiles() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
        write_file(path(name), bytes);
        return path(name);
    }
    std::string write_png(const std::string& name, int width, int height) const {
        return write(name, encode_indexed_png(test::scattered_texels(width * height, 256), width, height, palette_));
    }
    /// What the error says, all of it; empty if there is none.
    std::string complaint_of_packing(const std::string& png) const {
        try {
            pack_textures({png}, path("out.wad"), palette_);
        } catch (const FileError& error) {
            return error.what();
        }
        return {};
    }

    const Palette palette_ = test::scattered_palette();

  private:
    static std::string test_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
    std::filesystem::path folder_;
};

TEST_F(TextureFiles, WhatIsPackedComesOutTheSame) {
    const std::vector<std::string> files{write_png("wall.png", 64, 32), write_png("#water.png", 16, 16),
                                         write_png("+0lamp.png", 32, 128)};
    pack_textures(files, path("all.wad"), palette_);
    unpack_textures(path("all.wad"), path("out"), palette_);
    for (const std::string& file : files) {
        const auto again = (std::filesystem::path(path("out")) / std::filesystem::path(file).filename()).string();
        EXPECT_EQ(read_file(again), read_file(file)) << file;
    }
}

TEST_F(TextureFiles, AHashStandsForTheStarOfLiquids) {
    EXPECT_EQ(read_png_texture(write_png("#lava.png", 16, 16), palette_).name, "*lava");
    EXPECT_EQ(file_of_texture_name("*lava"), "#lava.png");
    EXPECT_EQ(file_of_texture_name("../x"), ".._x.png");
}

TEST_F(TextureFiles, TrueColoursTakeTheNearestOfThePalette) {
    // The file's palette is another one, a little brighter by one in red: its indices mean nothing here.
    Palette brighter = palette_;
    for (Rgb8& colour : brighter.colours) colour.red = static_cast<std::uint8_t>(colour.red | 1);
    std::reverse(brighter.colours.begin(), brighter.colours.end());
    std::vector<std::uint8_t> texels(256);
    for (std::size_t i = 0; i < 256; ++i) texels[i] = static_cast<std::uint8_t>(i);
    const auto file = write("reversed.png", encode_indexed_png(texels, 16, 16, brighter));
    const MipTexture texture = read_png_texture(file, palette_);
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(texture.mips[0][i], 255 - i);
}

TEST_F(TextureFiles, TwoIndicesOfOneColourStayApart) {
    Palette twins = palette_;
    twins.colours[250] = twins.colours[10];
    const std::vector<std::uint8_t> texels(256, 250);
    write("glow.png", encode_indexed_png(texels, 16, 16, twins));
    EXPECT_EQ(read_png_texture(path("glow.png"), twins).mips[0][0], 250);
}

TEST_F(TextureFiles, BadPicturesAreNamed) {
    EXPECT_NE(complaint_of_packing(write("no.png", {1, 2, 3})).find("not a readable PNG"), std::string::npos);
    EXPECT_NE(complaint_of_packing(write_png("odd.png", 24, 16)).find("24x16"), std::string::npos);
    EXPECT_NE(complaint_of_packing(write_png("sixteen_letters_.png", 16, 16)).find("16 characters"), std::string::npos);
    EXPECT_NE(complaint_of_packing(path("absent.png")).find("absent.png: open: No such file"), std::string::npos);
    EXPECT_EQ(complaint_of_packing(write_png("fifteen_letters.png", 16, 16)), "");
}

TEST_F(TextureFiles, APaletteHas768Bytes) {
    const std::string file = write("short.lmp", std::vector<std::uint8_t>(767));
    EXPECT_THROW(read_parsed(file, read_palette), FileError);
    EXPECT_NO_THROW(read_parsed(write("right.lmp", std::vector<std::uint8_t>(768)), read_palette));
}

TEST_F(TextureFiles, NoPrefixOfAWadIsTakenForAWhole) {
    const MipTexture texture = make_mip_texture("wall", 16, 16, test::scattered_texels(256, 256), palette_);
    const auto whole = write_wad(std::span(&texture, 1));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_THROW(read_textures(std::span(whole).first(size)), InputError) << size;
    }
    EXPECT_EQ(read_textures(whole).size(), 1u);
}

TEST_F(TextureFiles, EveryTextureOfARealLevelSurvivesUnpackingAndPacking) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const auto level = test::read_shared_file("dm4.bsp");
    const Palette palette = read_palette(test::read_shared_file("gfx/palette.lmp"));
    const auto textures = read_textures(level);
    ASSERT_GT(textures.size(), 10u);
    unpack_textures((test::find_shared_folder() / "levels" / "dm4.bsp").string(), path("dm4"), palette);
    for (const MipTexture& texture : textures) {
        const auto again = read_png_texture(path("dm4/" + file_of_texture_name(texture.name)), palette);
        EXPECT_EQ(again.name, texture.name);
        EXPECT_EQ(again.mips[0], texture.mips[0]) << texture.name;
    }
}

}  // namespace
}  // namespace oblong
