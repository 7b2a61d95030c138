#include "engine/files/picture.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>

#include "engine/base/input_error.h"
#include "tests/files/png_writer.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

// 16x16, the left half (200, 40, 60), the right one (20, 120, 220); baseline.
constexpr std::string_view kTwoColoursJpeg =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000302020302020303030304030304050805050404050a070706080c0a0c"
    "0c0b0a0b0b0d0e12100d0e110e0b0b1016101113141515150c0f171816141812141514ffdb00430103040405040509050509140d0b0d"
    "1414141414141414141414141414141414141414141414141414141414141414141414141414141414141414141414141414ffc00011"
    "080010001003011100021101031101ffc4001500010100000000000000000000000000000607ffc40014100100000000000000000000"
    "000000000000ffc400160101010100000000000000000000000000080906ffc40014110100000000000000000000000000000000ffda"
    "000c03010002110311003f008d32468101c09283e0fab5901c0928ffd9";
// 32x32, grey 255 at the top, evenly to 0 at the bottom; progressive.
constexpr std::string_view kGradientJpeg =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e2931"
    "302e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffc2000b080020002001011100ffc400150001"
    "0100000000000000000000000000000005ffda0008010100000001bc25894258ffc40015100101000000000000000000000000000000"
    "12ffda0008010100010502b5ad6b5ad6b5ad6b5ad6ffc40014100100000000000000000000000000000040ffda0008010100063f0207"
    "ffc40014100100000000000000000000000000000040ffda0008010100013f2107ff00ff00ffda000801010000001000ff00ffc40015"
    "10010100000000000000000000000000000071ffda0008010100013f10b5ad6b5ad6b5ad6b5ad6ffd9";

Bytes bytes_of(std::string_view digits) {
    Bytes bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16)));
    return bytes;
}

/// Texel (x, y) of the files below: every one another colour.
Rgb8 colour_at(int x, int y) {
    return {static_cast<std::uint8_t>(x * 7 + 3), static_cast<std::uint8_t>(y * 11 + 1),
            static_cast<std::uint8_t>(x * y + 90)};
}

/// As the specification of Truevision (1989) has it: header of 18 bytes, here rows from the top, then blue, green, red.
Bytes tga_header(int kind, int width, int height, int bits) {
    Bytes file{0, 0, static_cast<std::uint8_t>(kind), 0, 0, 0, 0, 0, 0, 0, 0, 0};
    ByteWriter(file).i16(width);
    ByteWriter(file).i16(height);
    file.push_back(static_cast<std::uint8_t>(bits));
    file.push_back(0x20);
    return file;
}

Bytes plain_tga(int width, int height) {
    Bytes file = tga_header(2, width, height, 24);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb8 colour = colour_at(x, y);
            file.insert(file.end(), {colour.blue, colour.green, colour.red});
        }
    return file;
}

/// 32 bits; each row a run of 16 of one colour, whose alpha is its number.
Bytes packed_tga() {
    Bytes file = tga_header(10, 16, 16, 32);
    for (int y = 0; y < 16; ++y) file.insert(file.end(), {0x8f, 30, 20, 10, static_cast<std::uint8_t>(y)});
    return file;
}

/// Microsoft's BITMAPINFOHEADER: rows from the bottom, each of a multiple of 4 bytes.
Bytes bmp(int width, int height) {
    Bytes file{'B', 'M'};
    ByteWriter out(file);
    for (const int value : {0, 0, 54, 40, width, height}) out.i32(value);
    out.i16(1).i16(24);
    for (int i = 0; i < 6; ++i) out.i32(0);
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            const Rgb8 colour = colour_at(x, y);
            file.insert(file.end(), {colour.blue, colour.green, colour.red});
        }
        while ((file.size() - 54) % 4 != 0) file.push_back(0);
    }
    return file;
}

std::string complaint_of(const Bytes& file) {
    return refusal([&] { decode_picture(file); });
}

void expect_the_colours(const PngImage& image, int width, int height) {
    ASSERT_EQ(image.width_px, width);
    ASSERT_EQ(image.height_px, height);
    EXPECT_TRUE(image.indices.empty());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(image.pixel(static_cast<std::size_t>(y * width + x)), (Rgba8{colour_at(x, y), 255}))
                << x << ' ' << y;
}

TEST(Picture, TgaAndBmpHoldTheirColours) {
    expect_the_colours(decode_picture(plain_tga(21, 17)), 21, 17);
    expect_the_colours(decode_picture(bmp(21, 17)), 21, 17);
    const PngImage packed = decode_picture(packed_tga());
    for (std::size_t i = 0; i < 256; ++i)
        ASSERT_EQ(packed.pixel(i), (Rgba8{{10, 20, 30}, static_cast<std::uint8_t>(i / 16)}));
}

// As near as the quantisation of a quality of 90 and 60 allows.
TEST(Picture, JpegIsNearItsColours) {
    const PngImage two = decode_picture(bytes_of(kTwoColoursJpeg)), gradient = decode_picture(bytes_of(kGradientJpeg));
    ASSERT_EQ(two.colours.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) {
        const Rgb8 is = two.pixel(i).colour, was = i % 16 < 8 ? Rgb8{200, 40, 60} : Rgb8{20, 120, 220};
        EXPECT_NEAR(is.red, was.red, 4);
        EXPECT_NEAR(is.green, was.green, 4);
        EXPECT_NEAR(is.blue, was.blue, 4);
    }
    ASSERT_EQ(gradient.colours.size(), 1024u);
    for (std::size_t i = 0; i < 1024; ++i)
        EXPECT_NEAR(gradient.pixel(i).colour.green, 255 - static_cast<double>(i / 32) * 255 / 31, 6) << i;
}

// What stb decodes by, tables of codes and of factors, is read even where the file has none.
TEST(Picture, OfAJpegWithoutItsTablesNothingIsLeftToChance) {
    for (const std::uint8_t marker : {std::uint8_t{0xc4}, std::uint8_t{0xdb}}) {
        Bytes jpeg = bytes_of(kTwoColoursJpeg);
        for (std::size_t i = 0; i + 1 < jpeg.size(); ++i)
            if (jpeg[i] == 0xff && jpeg[i + 1] == marker) jpeg[i + 1] = 0xfe;  // a comment
        mallopt(M_PERTURB, 0x41);
        const PngImage one = decode_picture(jpeg);
        mallopt(M_PERTURB, 0x12);
        const PngImage other = decode_picture(jpeg);
        mallopt(M_PERTURB, 0);
        EXPECT_EQ(one.colours, other.colours) << int{marker};
    }
}

TEST(Picture, APngIsReadAsEver) {
    const Bytes file = encode_indexed_png(Bytes{1, 2, 3, 4}, 2, 2, {});
    EXPECT_EQ(decode_picture(file).indices, (Bytes{1, 2, 3, 4}));
}

TEST(Picture, FaultsAreNamed) {
    EXPECT_TRUE(complaint_of({}).starts_with("image: not a readable PNG, JPEG, BMP or TGA"));
    EXPECT_TRUE(complaint_of({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0, 0, 0, 0}).starts_with("image: not a readable"));
    EXPECT_TRUE(complaint_of(tga_header(2, 4097, 1, 24)).starts_with("image: ")) << "too large";
    EXPECT_TRUE(complaint_of(tga_header(2, 65535, 65535, 24)).starts_with("image: ")) << "too large";
    EXPECT_TRUE(complaint_of(tga_header(2, 0, 16, 24)).starts_with("image: "));
    EXPECT_EQ(complaint_of(tga_header(10, 16, 16, 24)), "image: the file ends within the picture, expected all of it");
    Bytes jpeg = bytes_of(kTwoColoursJpeg);
    const std::array<std::uint8_t, 2> kTableMarker{0xff, 0xc4};
    const auto counts = std::search(jpeg.begin(), jpeg.end(), kTableMarker.begin(), kTableMarker.end()) + 5;
    std::fill_n(counts, 2, std::uint8_t{200});
    EXPECT_TRUE(complaint_of(jpeg).starts_with("image: a Huffman table of 4"));
}

/// A file of each kind, by its number.
class PictureFiles : public testing::TestWithParam<int> {
  protected:
    static Bytes file() {
        const std::array<Bytes, 5> files{plain_tga(21, 17), packed_tga(), bmp(21, 17), bytes_of(kTwoColoursJpeg),
                                         bytes_of(kGradientJpeg)};
        return files[static_cast<std::size_t>(GetParam())];
    }
};

TEST_P(PictureFiles, NoPrefixIsTakenForAWhole) {
    const Bytes whole = file();
    EXPECT_EQ(complaint_of(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size)
        ASSERT_NE(complaint_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
}

INSTANTIATE_TEST_SUITE_P(EachKind, PictureFiles, testing::Range(0, 5));

}  // namespace
}  // namespace oblong::test
