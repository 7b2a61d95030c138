#include "tools/texture/texture_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "engine/io/files.h"
#include "engine/io/wad.h"
#include "engine/level/bsp_read.h"
#include "engine/pictures/picture.h"
#include "engine/programs/arguments.h"
#include "tests/files/png_writer.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"
#include "tests/texture/test_palette.h"

namespace oblong {
namespace {

MipTexture read_picture(const std::string& file, const Palette& palette, PngColours colours = {}) {
    return picture_texture(file, read_file(file), palette, colours);
}

class TextureFiles : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string write(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
        write_file(path(name), bytes);
        return path(name);
    }
    std::string write_png(const std::string& name, int width, int height) const {
        return write(name, encode_indexed_png(test::scattered_texels(width * height, 256), width, height, palette_));
    }
    MipTexture texture(const std::string& name, int colours = 256) const {
        return make_mip_texture(name, 16, 16, test::scattered_texels(256, colours), palette_);
    }
    /// The names of what was packed.
    std::vector<std::string> packed() const {
        std::vector<std::string> names;
        const auto wad = read_file(path("out.wad"));
        for (const WadTexture& one : read_wad(wad)) names.push_back(one.name);
        return names;
    }
    /// What the error says, all of it; empty if there is none.
    std::string complaint_of_packing(const std::string& png) const { return complaint_of_packing(std::vector{png}); }
    std::string complaint_of_packing(const std::vector<std::string>& files) const {
        return test::refusal<FileError>([&] { pack_textures(files, {}, path("out.wad"), palette_); });
    }

    const Palette palette_ = test::scattered_palette();

  private:
    const test::TemporaryFolder folder_;
};

TEST_F(TextureFiles, WhatIsPackedComesOutTheSame) {
    const std::vector<std::string> files{write_png("wall.png", 64, 32), write_png("#water.png", 16, 16),
                                         write_png("+0lamp.png", 32, 128)};
    pack_textures(files, {}, path("all.wad"), palette_);
    unpack_textures(path("all.wad"), path("out"), palette_);
    for (const std::string& file : files) {
        const auto again = (std::filesystem::path(path("out")) / std::filesystem::path(file).filename()).string();
        EXPECT_EQ(read_file(again), read_file(file)) << file;
    }
}

TEST_F(TextureFiles, WhatIsNeitherAWadNorALevelIsNotUnpacked) {
    for (const std::string& file : {write("text.wad", {'t', 'e', 'x', 't'}), write("empty.wad", {})})
        EXPECT_EQ(test::refusal<FileError>([&] { unpack_textures(file, path("out"), palette_); }),
                  file + ": header: of another kind of file, expected a WAD2 or a level");
}

TEST_F(TextureFiles, NameInAWadsDirectoryCounts) {
    auto bytes = write_wad(std::vector{texture("wall")});
    bytes[12] = 0;  // of the name before the texels
    unpack_textures(write("unnamed.wad", bytes), path("out"), palette_);
    EXPECT_TRUE(std::filesystem::exists(path("out/wall.png")));
}

TEST_F(TextureFiles, AFolderStandsForItsPictures) {
    std::filesystem::create_directories(path("all"));
    for (const std::string name : {"all/b.png", "all/A.PNG", "all/*c.png"}) write_png(name, 16, 16);
    write("all/notes.txt", {1});
    const std::string more = write_png("more.png", 16, 16);
    EXPECT_TRUE(pack_textures({path("all"), more}, {}, path("out.wad"), palette_).empty());
    EXPECT_EQ(packed(), (std::vector<std::string>{"*c", "A", "b", "more"}));
    std::filesystem::create_directories(path("none"));
    EXPECT_EQ(complaint_of_packing(path("none")),
              path("none") + ": folder: has no pictures, expected PNG, TGA, JPEG or BMP files");
}

TEST_F(TextureFiles, WhatALevelWouldNotShowAsMeantIsNamed) {
    struct Case {
        std::string name;
        int width, height;
        std::string warning;
    };
    const std::string shape = ", expected two squares side by side, such as 256x128; it is of one colour";
    for (const auto& [name, width, height, warning] : {
             Case{"sky1", 256, 128, ""},
             Case{"sky_small", 32, 16, ""},
             Case{"sky2", 128, 128, "sky 'sky2': 128x128" + shape},
             Case{"sky3", 128, 256, "sky 'sky3': 128x256" + shape},
             Case{"sky4", 96, 48, "sky 'sky4': 96x48" + shape},
             Case{"+2lamp", 16, 16,
                  "animated texture 'lamp': frame '+1lamp' is missing, expected no gap; it stands still"},
             Case{"+blamp", 16, 16,
                  "animated texture 'lamp': frame '+alamp' is missing, expected no gap; it stands still"},
             Case{"+1lamp", 32, 16,
                  "animated texture 'lamp': '+1lamp' and '+0lamp' differ in size, expected frames of one size; it "
                  "stands "
                  "still"},
             Case{"+1lamp", 16, 16, ""},
         })
        EXPECT_EQ(pack_textures({write_png("+0lamp.png", 16, 16), write_png(name + ".png", width, height)}, {},
                                path("out.wad"), palette_),
                  warning.empty() ? TextureWarnings{} : TextureWarnings{warning})
            << name;
}

TEST_F(TextureFiles, OddTexturesOfAWadAreNamedAndTheRestIsUnpacked) {
    const auto good = write_wad(std::vector{texture("one"), texture("two"), texture("three")});
    constexpr std::size_t kMiptex_bytes = 40 + 256 + 64 + 16 + 4, kTwo = 12 + kMiptex_bytes,
                          kEntry = 12 + 3 * kMiptex_bytes + 32;
    struct Case {
        std::size_t at;
        std::uint8_t to;
        std::string warning;
    };
    for (const auto& [at, to, warning] : {
             Case{kTwo + 16, 24, "texture 'two': 24x16, expected multiples of 16 up to 4096"},
             Case{kTwo + 16, 0, "texture 'two': 0x16, expected multiples of 16 up to 4096"},
             Case{kTwo + 24, 3, "texture 'two': mip level 0 at offset 3, expected 40 or more, behind its header"},
             Case{kEntry + 3, 1,
                  "texture 'two': 380 bytes at offset 16777608, expected them within the 1248 that there are"},
             Case{kTwo + 17, 1, "texture 'two': 4352 bytes at offset 40, expected them within the 380 that there are"},
         }) {
        auto bytes = good;
        bytes[at] = to;
        std::filesystem::remove_all(path("out"));
        EXPECT_EQ(unpack_textures(write("odd.wad", bytes), path("out"), palette_), TextureWarnings{warning});
        for (const std::string name : {"one", "two", "three"})
            EXPECT_EQ(std::filesystem::exists(path("out/" + name + ".png")), name != "two") << warning;
    }
    auto only = write_wad(std::vector{texture("two")});
    only[12 + 16] = 24;
    EXPECT_EQ(test::refusal<FileError>([&] { unpack_textures(write("only.wad", only), path("none"), palette_); }),
              path("only.wad") +
                  ": textures: none can be read, expected one or more; texture 'two': 24x16, expected "
                  "multiples of 16 up to 4096");
    EXPECT_FALSE(std::filesystem::exists(path("none")));
}

TEST_F(TextureFiles, OddPicturesAreNamedAndTheRestIsPacked) {
    std::filesystem::create_directories(path("all"));
    write_png("all/wall.png", 16, 16);
    const std::string odd = write_png("all/odd.png", 30, 16), broken = write("all/broken.bmp", {'B', 'M'}),
                      name = write_png("all/sixteen_letters_.png", 16, 16);
    EXPECT_EQ(pack_textures({path("all")}, {}, path("out.wad"), palette_),
              (TextureWarnings{broken + ": image: the file ends within the picture, expected all of it",
                               odd + ": image: 30x16, expected multiples of 16 up to 4096",
                               name + ": name: 'sixteen_letters_' has 16 characters, expected 1 to 15 of a texture's "
                                      "name"}));
    EXPECT_EQ(packed(), std::vector<std::string>{"wall"});
    EXPECT_NE(complaint_of_packing({path("all"), path("absent.png")}).find("absent.png: open: "), std::string::npos);
}

TEST_F(TextureFiles, NoneIsUnpackedOverAnother) {
    const std::string file = write("two.wad", write_wad(std::vector{texture("*a"), texture("#a", 7)}));
    EXPECT_EQ(unpack_textures(file, path("out"), palette_),
              TextureWarnings{"texture '#a': is the second one for the file '#a.png', expected one for each"});
    EXPECT_EQ(decode_png(read_file(path("out/#a.png"))).indices, test::scattered_texels(256, 256));
}

TEST_F(TextureFiles, AHashStandsForTheStarOfLiquids) {
    EXPECT_EQ(read_picture(write_png("#lava.png", 16, 16), palette_).name, "*lava");
    EXPECT_EQ(file_of_texture_name("*lava"), "#lava.png");
    EXPECT_EQ(file_of_texture_name("../x"), ".._x.png");
}

// A ramp of 256 colours as true colours: of a palette that has each of them, 32 glow.
class TrueColours : public TextureFiles {
  protected:
    TrueColours() {
        test::PngBytes rows;
        for (std::size_t i = 0; i < 256; ++i) {
            if (i % 16 == 0) rows.push_back(0);
            const Rgb8 colour = palette_.colours[i];
            rows.insert(rows.end(), {colour.red, colour.green, colour.blue});
        }
        ramp_ = test::png_of_rows(test::png_header(16, 16, 8, 2), rows);
    }
    static int glowing_texels(const MipTexture& texture) {
        int count = 0;
        for (const auto& mip : texture.mips)
            count += static_cast<int>(std::count_if(mip.begin(), mip.end(), [](int texel) { return texel >= 224; }));
        return count;
    }
    test::PngBytes ramp_;
};

TEST_F(TrueColours, TakeTheNearestColourThatDoesNotGlow) {
    const MipTexture texture = read_picture(write("ramp.png", ramp_), palette_);
    for (std::size_t i = 0; i < 224; ++i) EXPECT_EQ(texture.mips[0][i], i);
    EXPECT_EQ(glowing_texels(texture), 0);
}

TEST_F(TrueColours, GlowWhereThatIsAskedFor) {
    const MipTexture texture = read_picture(write("ramp.png", ramp_), palette_, {.may_glow = true});
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(texture.mips[0][i], i);
}

TEST_F(TrueColours, GlowInThePackedTexturesThatAreNamed) {
    pack_textures({write("one.png", ramp_), write("Two.png", ramp_)}, {"two"}, path("out.wad"), palette_);
    const auto wad = read_file(path("out.wad"));
    const auto textures = read_wad(wad);
    ASSERT_EQ(textures.size(), 2u);
    EXPECT_EQ(glowing_texels(parse_miptex(textures[0].miptex)), 0);
    EXPECT_GT(glowing_texels(parse_miptex(textures[1].miptex)), 31);
    EXPECT_EQ(
        test::refusal<UsageError>([&] { pack_textures({path("one.png")}, {"three"}, path("out.wad"), palette_); }),
        "--glow: 'three', expected the name of one of the textures");
    EXPECT_THROW(pack_textures({path("one.png")}, {}, path("Two.png"), palette_), UsageError) << "a picture is there";
}

TEST_F(TrueColours, OfAPngWithAnotherPaletteAreWhatCounts) {
    Palette reversed = palette_;
    std::reverse(reversed.colours.begin(), reversed.colours.end());
    std::vector<std::uint8_t> texels(256);
    std::iota(texels.begin(), texels.end(), std::uint8_t{0});
    const auto file = write("reversed.png", encode_indexed_png(texels, 16, 16, reversed));
    const MipTexture texture = read_picture(file, palette_, {.may_glow = true});
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(texture.mips[0][i], 255 - i);
}

/// A palette of greys 16 apart, and a picture of 32x32 in one grey, by default half-way between two of them.
struct BetweenGreys {
    Palette palette;
    PngImage image;

    explicit BetweenGreys(std::uint8_t level = 104)
        : image{32, 32, {}, std::vector<Rgba8>(32 * 32, {{level, level, level}, 255})} {
        for (std::size_t i = 0; i < 256; ++i) {
            const auto grey = static_cast<std::uint8_t>(i % 16 * 16);
            palette.colours[i] = {grey, grey, grey};
        }
    }
};

TEST(Quantise, TheNearestColourIsTheNearestOfAllInDoubles) {
    const Palette palette = test::scattered_palette();
    PngImage image{64, 64, {}, {}};
    for (int i = 0; i < 64 * 64; ++i)
        image.colours.push_back({{static_cast<std::uint8_t>(i * 37 / 16), static_cast<std::uint8_t>(i * i / 53),
                                  static_cast<std::uint8_t>(i * 101 / 7)}});
    for (const ColourRange range :
         {ColourRange{0, 256}, kOrdinaryColours, ColourRange{40, 41}, ColourRange{100, 130}}) {
        const std::vector<std::uint8_t> indices = indices_of(image, palette, range, Dither::None);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const auto distance = [&, wanted = image.colours[i].colour](int index) {
                const Rgb8 colour = palette.colours[static_cast<std::size_t>(index)];
                return std::hypot(0.0 + colour.red - wanted.red, 0.0 + colour.green - wanted.green,
                                  0.0 + colour.blue - wanted.blue);
            };
            ASSERT_GE(indices[i], range.begin);
            ASSERT_LT(indices[i], range.end);
            for (int other = range.begin; other < range.end; ++other)
                ASSERT_GE(distance(other) + 1e-9, distance(indices[i])) << i << ' ' << other;
        }
    }
}

// A pixel passes on 8 at most, half of 16; of that, 9/16 to the next row and up to 11/16 over a side of a block. What
// a block of 8x8 takes in or gives away is then 8 (2 * 8 * 9 + 2 * 8 * 11) / 16 at most, 2.5 a pixel, and rounding.
TEST(Quantise, DitheringKeepsTheMeanOfEachBlock) {
    for (int level = 8; level <= 232; ++level) {
        const BetweenGreys scene(static_cast<std::uint8_t>(level));
        const auto indices = indices_of(scene.image, scene.palette, kOrdinaryColours, Dither::FloydSteinberg);
        double all = 0;
        for (int block = 0; block < 16; ++block) {
            double sum = 0;
            for (int i = 0; i < 64; ++i) {
                const int x = block % 4 * 8 + i % 8, y = block / 4 * 8 + i / 8;
                sum += scene.palette.colours[indices[static_cast<std::size_t>(y * 32 + x)]].red;
            }
            ASSERT_NEAR(sum / 64, level, 2.75) << block;
            all += sum / 64 / 16;
        }
        ASSERT_NEAR(all, level, 2.75 / 4) << "a block of 32x32";
    }
}

// The palette lacks the greys between 100 and 132: a pixel of 116 is 16 too bright for its colour. Floyd and
// Steinberg's sixteenths of that (1976) are whole greys, which the pixels around it have.
TEST(Quantise, DitheringPassesOnTheSixteenthsOfFloydAndSteinberg) {
    BetweenGreys scene(50);
    for (std::size_t i = 0; i < 256; ++i) {
        const auto grey = static_cast<std::uint8_t>(i <= 100 ? i : std::max<std::size_t>(i, 132));
        scene.palette.colours[i] = {grey, grey, grey};
    }
    for (const std::size_t row : {4, 9}) {  // from left to right, and from right to left
        BetweenGreys spoilt = scene;
        spoilt.image.colours[row * 32 + 10].colour = {116, 116, 116};
        std::vector<std::uint8_t> expected(32 * 32, 50);
        const std::size_t place = row * 32 + 10, ahead = row == 4 ? 1 : static_cast<std::size_t>(-1);
        expected[place] = 100;
        for (const auto& [at, sixteenths] :
             {std::pair{ahead, 7}, {32 - ahead, 3}, {std::size_t{32}, 5}, {32 + ahead, 1}})
            expected[place + at] = static_cast<std::uint8_t>(50 + sixteenths);
        EXPECT_EQ(indices_of(spoilt.image, scene.palette, kOrdinaryColours, Dither::FloydSteinberg), expected);
    }
}

TEST(Quantise, ColoursBeyondThePalettesDoNotAddUp) {
    // Half white, then a grey that the palette has: what white lacked must not brighten it for long.
    BetweenGreys scene(255);
    for (std::size_t i = 512; i < 1024; ++i) scene.image.colours[i].colour = {96, 96, 96};
    const auto indices = indices_of(scene.image, scene.palette, kOrdinaryColours, Dither::FloydSteinberg);
    for (std::size_t i = 512 + 4 * 32; i < 1024; ++i) ASSERT_EQ(indices[i] % 16, 6) << i;
}

TEST(Quantise, DitheringLeavesColoursOfThePaletteAlone) {
    BetweenGreys scene;
    for (std::size_t i = 0; i < scene.image.colours.size(); ++i)
        scene.image.colours[i].colour = scene.palette.colours[i % 16];
    EXPECT_EQ(indices_of(scene.image, scene.palette, kOrdinaryColours, Dither::FloydSteinberg),
              indices_of(scene.image, scene.palette, kOrdinaryColours, Dither::None));
}

TEST(Quantise, DitheringTakesAnyRangeOfColours) {
    const BetweenGreys scene;
    for (const ColourRange range : {ColourRange{0, 1}, ColourRange{5, 7}, ColourRange{0, 256}, ColourRange{224, 255}})
        for (const std::uint8_t index : indices_of(scene.image, scene.palette, range, Dither::FloydSteinberg)) {
            ASSERT_GE(index, range.begin);
            ASSERT_LT(index, range.end);
        }
}

TEST_F(TextureFiles, TwoIndicesOfOneColourStayApart) {
    Palette twins = palette_;
    twins.colours[250] = twins.colours[10];
    const std::vector<std::uint8_t> texels(256, 250);
    write("glow.png", encode_indexed_png(texels, 16, 16, twins));
    EXPECT_EQ(read_picture(path("glow.png"), twins).mips[0][0], 250);
}

// As picture editors write it: only as much of the palette as the picture needs.
TEST_F(TextureFiles, IndicesOfAShorterPaletteStay) {
    test::PngBytes rows(17 * 16, 2), start;
    for (std::size_t row = 0; row < 16; ++row) rows[row * 17] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Rgb8 colour = palette_.colours[i];
        start.insert(start.end(), {colour.red, colour.green, colour.blue});
    }
    Palette twins = palette_;
    twins.colours[1] = twins.colours[2];
    std::copy_n(start.begin() + 6, 3, start.begin() + 3);
    const auto file = write("short.png", test::png_of_rows(test::png_header(16, 16, 8, 3), rows, {{"PLTE", start}}));
    EXPECT_EQ(read_picture(file, twins).mips[0][0], 2);
}

/// 16x16, alpha 0 in the left half and 255 in the right.
test::PngBytes half_transparent(Rgb8 colour) {
    test::PngBytes rows;
    for (int row = 0; row < 16; ++row) {
        rows.push_back(0);
        for (int column = 0; column < 16; ++column) {
            const std::uint8_t alpha = column < 8 ? 0 : 255;
            rows.insert(rows.end(), {colour.red, colour.green, colour.blue, alpha});
        }
    }
    return test::png_of_rows(test::png_header(16, 16, 8, 6), rows);
}

TEST_F(TextureFiles, TransparentPixelsAreHolesWhereTheNameSaysSo) {
    // The colour of a hole itself, solid here: it must not become one.
    const auto file = write("{grate.png", half_transparent(palette_.colours[255]));
    for (const bool may_glow : {false, true}) {
        const MipTexture texture = read_picture(file, palette_, {.may_glow = may_glow});
        for (std::size_t level = 0; level < 4; ++level) {
            const std::size_t width = std::size_t{16} >> level;
            for (std::size_t at = 0; at < width * width; ++at)
                EXPECT_EQ(texture.mips[level][at] == 255, at % width < width / 2) << level << ' ' << at;
        }
    }
}

TEST_F(TextureFiles, TransparentPixelsElsewhereAreAnError) {
    const std::string grate = write("grate.png", half_transparent({1, 2, 3}));
    EXPECT_EQ(
        complaint_of_packing(grate),
        grate + ": image: has transparent pixels, expected none: only a texture whose name begins with '{' has holes");
}

TEST_F(TextureFiles, TwoSourcesOfOneNameAreAnError) {
    std::filesystem::create_directories(path("more"));
    const std::string one = write_png("wall.png", 16, 16), other = write_png("more/Wall.png", 16, 16);
    const std::string said = complaint_of_packing(std::vector{one, other});
    EXPECT_NE(said.find(one), std::string::npos) << said;
    EXPECT_NE(said.find(other), std::string::npos) << said;
    EXPECT_FALSE(std::filesystem::exists(path("out.wad")));
}

TEST_F(TextureFiles, BadPicturesAreNamed) {
    EXPECT_NE(complaint_of_packing(write("no.png", {1, 2, 3})).find("not a readable PNG"), std::string::npos);
    EXPECT_NE(complaint_of_packing(write_png("odd.png", 24, 16)).find("24x16"), std::string::npos);
    const std::string long_name = write_png("sixteen_letters_.png", 16, 16);
    EXPECT_EQ(complaint_of_packing(long_name),
              long_name + ": name: 'sixteen_letters_' has 16 characters, expected 1 to 15 of a texture's name");
    EXPECT_NE(complaint_of_packing(path("absent.png")).find("absent.png: open: No such file"), std::string::npos);
    EXPECT_EQ(complaint_of_packing(write_png("fifteen_letters.png", 16, 16)), "");
}

TEST_F(TextureFiles, EveryTextureOfARealLevelSurvivesUnpackingAndPacking) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const auto level = test::read_shared_file("dm4.bsp");
    const Palette palette = read_palette(test::read_shared_file("gfx/palette.lmp"));
    const auto textures = read_bsp_textures(level);
    ASSERT_GT(textures.size(), 10u);
    unpack_textures((test::find_shared_folder() / "levels" / "dm4.bsp").string(), path("dm4"), palette);
    for (const MipTexture& texture : textures) {
        const auto again = read_picture(path("dm4/" + file_of_texture_name(texture.name)), palette);
        EXPECT_EQ(again.name, texture.name);
        EXPECT_EQ(again.mips[0], texture.mips[0]) << texture.name;
    }
}

}  // namespace
}  // namespace oblong
