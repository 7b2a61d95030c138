#include "engine/pictures/picture.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>

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
// 18x1, its first 16 columns (200, 40, 60), the others (20, 120, 220); half the columns of hue.
constexpr std::string_view kHalfColumnsJpeg =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000201010101010201010102020202020403020202020504040304060506"
    "060605060606070908060709070606080b08090a0a0a0a0a06080b0c0b0a0c090a0a0affdb004301020202020202050303050a070607"
    "0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0affc00011"
    "080001001203012100021101031101ffc400160001010100000000000000000000000000000608ffc400141001000000000000000000"
    "00000000000000ffc40016010101010000000000000000000000000009070affc40014110100000000000000000000000000000000ff"
    "da000c03010002110311003f00cce2764e160150677dffd9";
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

/// A way to write a BMP, by Microsoft's and OS/2's descriptions.
struct BmpKind {
    int head = 40, bits = 24;
    std::vector<std::uint32_t> masks = {};  ///< of red, green, blue, maybe alpha
    bool is_from_top = false;
    int gap = 0;  ///< bytes between head and pixels

    bool has_palette() const { return bits <= 8; }
    std::uint32_t mask(std::size_t part) const {
        constexpr std::uint32_t kOf16[] = {31 << 10, 31 << 5, 31, 0}, kOf32[] = {255 << 16, 255 << 8, 255, 0};
        return part < masks.size() ? masks[part] : bits == 16 ? kOf16[part] : kOf32[part];
    }
    /// The colour that is left of one of 8 bits, and the bits of the file.
    static std::uint32_t bits_of(std::uint8_t value, std::uint32_t mask) {
        return mask == 0 ? 0
                         : static_cast<std::uint32_t>(std::lround(value / 255.0 * (mask >> std::countr_zero(mask))))
                               << std::countr_zero(mask);
    }
};

Bytes bmp(int width, int height, const BmpKind& kind = {}) {
    Bytes file{'B', 'M'};
    ByteWriter out(file);
    const bool is_core = kind.head == 12;
    const int colours = kind.has_palette() ? 1 << kind.bits : 0;
    const int after_head = kind.head == 40 ? static_cast<int>(kind.masks.size()) * 4 : 0;
    for (const int value : {0, 0, 14 + kind.head + after_head + colours * (is_core ? 3 : 4) + kind.gap, kind.head})
        out.i32(value);
    if (is_core) {
        out.i16(width).i16(height).i16(1).i16(kind.bits);
    } else {
        out.i32(width).i32(kind.is_from_top ? -height : height).i16(1).i16(kind.bits);
        out.i32(kind.masks.empty() ? 0 : kind.masks.size() == 4 && kind.head == 40 ? 6 : 3);
        for (int i = 0; i < 5; ++i) out.i32(0);
        for (const std::uint32_t mask : kind.masks) out.i32(static_cast<std::int32_t>(mask));
        file.resize(as_size(14 + kind.head + after_head));
    }
    for (int i = 0; i < colours; ++i) {
        const Rgb8 colour = colour_at(i % 16, i / 16);
        file.insert(file.end(), {colour.blue, colour.green, colour.red});
        if (!is_core) file.push_back(0);
    }
    file.resize(file.size() + as_size(kind.gap));
    const std::size_t start = file.size();
    for (int i = 0; i < height; ++i) {
        const int y = kind.is_from_top ? i : height - 1 - i;
        std::uint32_t bits = 0;
        int count = 0;
        for (int x = 0; x < width; ++x) {
            const Rgb8 colour = colour_at(x, y);
            if (kind.bits == 24) file.insert(file.end(), {colour.blue, colour.green, colour.red});
            const std::uint32_t parts = BmpKind::bits_of(colour.red, kind.mask(0)) |
                                        BmpKind::bits_of(colour.green, kind.mask(1)) |
                                        BmpKind::bits_of(colour.blue, kind.mask(2)) | kind.mask(3);
            if (kind.bits == 16) out.i16(static_cast<std::int16_t>(parts));
            if (kind.bits == 32) out.i32(static_cast<std::int32_t>(parts));
            if (!kind.has_palette()) continue;
            bits = bits << kind.bits | static_cast<std::uint32_t>(x + 16 * y) % (1u << kind.bits);
            count += kind.bits;
            if (count % 8 == 0) file.push_back(static_cast<std::uint8_t>(bits));
        }
        if (count % 8 != 0) file.push_back(static_cast<std::uint8_t>(bits << (8 - count % 8)));
        while ((file.size() - start) % 4 != 0) file.push_back(0);
    }
    return file;
}

std::string complaint_of(const Bytes& file) {
    return refusal([&] { decode_picture(file); });
}

TEST(Picture, EveryKindOfBmpHasItsPixelsInTheirPlaces) {
    const std::vector<std::uint32_t> r5g6b5{31u << 11, 63u << 5, 31u}, rgba{255u << 24, 255u << 16, 255u << 8, 255u},
        argb4{15u << 8, 15u << 4, 15u, 15u << 12}, rgb10{1023u << 20, 1023u << 10, 1023u};
    std::vector<BmpKind> kinds;
    for (const int bits : {1, 2, 4, 8, 16, 24, 32})
        for (const int head : {12, 16, 40, 52, 56, 64, 108, 124})
            for (const bool is_from_top : {false, true})
                if (!is_from_top || head > 12) kinds.push_back({head, bits, {}, is_from_top, head == 40 ? 4 : 0});
    for (const int head : {40, 52, 56, 108, 124})
        for (const auto& masks : {r5g6b5, rgba, argb4, rgb10})
            if (masks.size() == 3 || head != 52)
                kinds.push_back({head, masks == r5g6b5 || masks == argb4 ? 16 : 32, masks, false, 0});
    for (const BmpKind& kind : kinds) {
        const PngImage image = decode_picture(bmp(21, 17, kind));
        ASSERT_EQ(std::pair(image.width_px, image.height_px), std::pair(21, 17));
        ASSERT_EQ(image.colours.size(), 21u * 17);
        EXPECT_TRUE(image.indices.empty());
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 21; ++x) {
                const int index = (x + 16 * y) % (1 << kind.bits % 24);
                const Rgb8 was = kind.has_palette() ? colour_at(index % 16, index / 16) : colour_at(x, y);
                const Rgba8 is = image.pixel(as_size(y * 21 + x));
                const auto near = [&](std::uint8_t value, std::uint8_t wanted, std::size_t part) {
                    const std::uint32_t mask = kind.mask(part);
                    const bool is_exact = kind.bits <= 8 || kind.bits == 24 || std::popcount(mask) == 8;
                    const double step = is_exact ? 0 : 255.0 / ((1 << std::popcount(mask)) - 1);
                    return std::abs(value - wanted) <= step / 2 + (is_exact ? 0 : 1);
                };
                ASSERT_TRUE(near(is.colour.red, was.red, 0) && near(is.colour.green, was.green, 1) &&
                            near(is.colour.blue, was.blue, 2) && is.alpha == 255)
                    << kind.head << ' ' << kind.bits << ' ' << kind.masks.size() << ": " << x << ' ' << y;
            }
    }
}

TEST(Picture, ATgaBeginsInAnyCornerAndMayBePacked) {
    for (const int corner : {0x00, 0x10, 0x20, 0x30}) {
        Bytes file = plain_tga(21, 17);
        file[17] = static_cast<std::uint8_t>(corner);
        const PngImage image = decode_picture(file);
        ASSERT_EQ(std::pair(image.width_px, image.height_px), std::pair(21, 17));
        EXPECT_TRUE(image.indices.empty());
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 21; ++x) {
                const int column = (corner & 0x10) != 0 ? 20 - x : x, row = (corner & 0x20) != 0 ? y : 16 - y;
                ASSERT_EQ(image.pixel(as_size(y * 21 + x)), (Rgba8{colour_at(column, row), 255})) << x << y;
            }
    }
    const PngImage packed = decode_picture(packed_tga());
    for (std::size_t i = 0; i < 256; ++i)
        ASSERT_EQ(packed.pixel(i), (Rgba8{{10, 20, 30}, static_cast<std::uint8_t>(i / 16)}));
}

TEST(Picture, ATgasColourMapMayBeginAtAnyNumberAndBeUnused) {
    Bytes mapped = tga_header(1, 2, 2, 8), coloured = tga_header(2, 1, 1, 24);
    mapped[0] = coloured[0] = 3;  // bytes of a name
    mapped[1] = coloured[1] = 1;
    mapped[3] = 10;
    mapped[5] = coloured[5] = 2;
    mapped[7] = coloured[7] = 24;
    const Bytes map{'a', 'b', 'c', 1, 2, 3, 4, 5, 6};
    mapped.insert(mapped.end(), map.begin(), map.end());
    mapped.insert(mapped.end(), {10, 11, 11, 10});
    coloured.insert(coloured.end(), map.begin(), map.end());
    coloured.insert(coloured.end(), {7, 8, 9});
    EXPECT_EQ(decode_picture(mapped).colours, (std::vector<Rgba8>{{{3, 2, 1}}, {{6, 5, 4}}, {{6, 5, 4}}, {{3, 2, 1}}}));
    EXPECT_EQ(decode_picture(coloured).colours, (std::vector<Rgba8>{{{9, 8, 7}}}));
    mapped.back() = 9;
    EXPECT_EQ(complaint_of(mapped), "image: a pixel of colour -1, expected one of the palette's 2");
}

TEST(Picture, ATgaOfGreysHasItsAlphaAndOneOf16BitsItsColours) {
    Bytes grey = tga_header(3, 1, 2, 16), packed = tga_header(10, 2, 1, 16);
    grey.insert(grey.end(), {77, 200, 5, 0});
    packed.insert(packed.end(), {0x81, 0x1f, 0x7c});
    EXPECT_EQ(decode_picture(grey).colours, (std::vector<Rgba8>{{{77, 77, 77}, 200}, {{5, 5, 5}, 0}}));
    EXPECT_EQ(decode_picture(packed).colours, (std::vector<Rgba8>(2, {{255, 0, 255}})));
}

// FF C4 begins a table of a JPEG, but in no other format, and not within another part of a JPEG.
TEST(Picture, NoBytesOfAPictureAreTakenForAJpegsTables) {
    Bytes tga = tga_header(2, 16, 16, 24), of_bmp = bmp(16, 16), jpeg = bytes_of(kTwoColoursJpeg);
    const Bytes blue{0xff, 0xc4, 0xb0};
    for (int i = 0; i < 256; ++i) {
        tga.insert(tga.end(), blue.begin(), blue.end());
        std::copy(blue.begin(), blue.end(), of_bmp.begin() + 54 + 3 * i);
    }
    const std::vector<Rgba8> colours(256, {{0xb0, 0xc4, 0xff}});
    EXPECT_EQ(decode_picture(tga).colours, colours);
    EXPECT_EQ(decode_picture(of_bmp).colours, colours);
    const std::vector<Rgba8> plain = decode_picture(jpeg).colours;
    Bytes comment{0xff, 0xfe, 0, 42, 0xff, 0xc4, 1, 0, 0};
    comment.resize(44, 200);
    jpeg.insert(jpeg.begin() + 2, comment.begin(), comment.end());
    EXPECT_EQ(decode_picture(jpeg).colours, plain);
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

// Between two values of hue, columns have 3 quarters of their own and 1 of the next (ISO/IEC 10918-5, triangle filter).
TEST(Picture, HueOfHalfTheColumnsIsInterpolatedUpToTheLast) {
    const PngImage image = decode_picture(bytes_of(kHalfColumnsJpeg));
    const double left[3] = {200, 40, 60}, right[3] = {20, 120, 220};
    const auto luma = [](const double(&c)[3]) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; };
    ASSERT_EQ(image.colours.size(), 18u);
    for (std::size_t x = 0; x < 18; ++x) {
        const double share = x < 15 ? 0 : x == 15 ? 0.25 : x == 16 ? 0.75 : 1;
        const Rgb8 is = image.pixel(x).colour;
        for (int i = 0; i < 3; ++i) {
            const double hue = (left[i] - luma(left)) * (1 - share) + (right[i] - luma(right)) * share;
            const double value = hue + (x < 16 ? luma(left) : luma(right));
            EXPECT_NEAR((i == 0 ? is.red : i == 1 ? is.green : is.blue), value, 3) << x << ", " << i;
        }
    }
}

// What stb decodes by, tables of codes and of factors, is read even where the file has none.
// Each scan costs the time of all pixels.
TEST(Picture, OfAJpegOnlySomeScansAreDecoded) {
    Bytes jpeg = bytes_of(kTwoColoursJpeg);
    const std::string_view scan("\xff\xda\0\x08\x01\x01\0\0\0\0", 10);
    for (int i = 0; i < 100; ++i) jpeg.insert(jpeg.end() - 2, scan.begin(), scan.end());
    EXPECT_EQ(complaint_of(jpeg), "image: a JPEG of more than 100 scans, expected fewer");
}

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
    for (const auto& [width, height] : {std::pair{4097, 1}, {65535, 65535}, {0, 16}})  // too large, and none
        EXPECT_TRUE(complaint_of(tga_header(2, width, height, 24)).starts_with("image: ")) << width;
    EXPECT_EQ(complaint_of(tga_header(10, 16, 16, 24)), "image: the file ends within the picture, expected all of it");
    Bytes interleaved = plain_tga(2, 4);
    interleaved[17] = 0x40;
    EXPECT_EQ(complaint_of(interleaved), "image: a TGA whose rows are interleaved, expected them in order");
    Bytes jpeg = bytes_of(kTwoColoursJpeg);
    Bytes wide = jpeg;
    const std::array<std::uint8_t, 2> kFrameMarker{0xff, 0xc0}, kTableMarker{0xff, 0xc4};
    const auto width = std::search(wide.begin(), wide.end(), kFrameMarker.begin(), kFrameMarker.end()) + 7;
    std::copy_n(std::array<std::uint8_t, 2>{0x10, 0x01}.begin(), 2, width);
    EXPECT_TRUE(complaint_of(wide).starts_with("image: 4097x")) << complaint_of(wide);
    const auto counts = std::search(jpeg.begin(), jpeg.end(), kTableMarker.begin(), kTableMarker.end()) + 5;
    std::fill_n(counts, 2, std::uint8_t{200});
    EXPECT_TRUE(complaint_of(jpeg).starts_with("image: a Huffman table of 4"));
    const auto of_bmp = [](std::size_t at, int value) {
        Bytes file = bmp(16, 16, {40, 8, {}, false, 0});
        for (const int shift : {0, 8, 16, 24}) file[at++] = static_cast<std::uint8_t>(value >> shift);
        return complaint_of(file);
    };
    for (const auto& [at, value, said] : {std::tuple<std::size_t, int, const char*>{
                                              14, 9, "a BMP whose head has 9 bytes, expected 12 (OS/2) or 16 to 124"},
                                          {18, -16, "-16x16 pixels, expected 1 to 4096 a side"},
                                          {22, INT32_MIN, "16x2147483648 pixels, expected 1 to 4096 a side"},
                                          {28, 3, "a BMP of 3 bits a pixel, expected 1, 2, 4, 8, 16, 24 or 32"},
                                          {30, 1, "a BMP compressed by way 1 (run lengths), expected none"},
                                          {46, 4, "a pixel of colour 240, expected one of the palette's 4"},
                                          {10, 20, "pixels at offset 20, expected them after the head"}})
        EXPECT_EQ(of_bmp(at, value), "image: " + std::string(said));
}

TEST(Picture, NoPrefixOfAnyKindIsTakenForAWhole) {
    for (const Bytes& file :
         {plain_tga(21, 17), packed_tga(), bmp(21, 17), bmp(21, 17, {12, 4}), bmp(21, 17, {40, 16, {0xf00, 0xf0, 0xf}}),
          bytes_of(kTwoColoursJpeg), bytes_of(kGradientJpeg)})
        expect_no_prefix_is_read(file, complaint_of);
}

}  // namespace
}  // namespace oblong::test
