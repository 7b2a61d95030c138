#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/base/input_error.h"
#include "engine/pictures/picture.h"
#include "tests/files/png_writer.h"
#include "tests/support/refusal.h"

namespace oblong::test::png_test {
namespace {

/// Colour i is (i, 255 - i, i xor 90): all different.
Palette distinct_colours() {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        palette.colours[static_cast<std::size_t>(i)] = {
            static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(i ^ 90)};
    }
    return palette;
}

/// Indices without a pattern, every one of them.
PngBytes many_indices(int count) {
    PngBytes pixels;
    for (int i = 0; i < count; ++i) pixels.push_back(static_cast<std::uint8_t>(i * i / 7 + i * 37));
    return pixels;
}

PngBytes inflated(const PngBytes& packed, std::size_t size) {
    PngBytes bytes(size);
    uLongf written = static_cast<uLongf>(size);
    EXPECT_EQ(uncompress(bytes.data(), &written, packed.data(), static_cast<uLong>(packed.size())), Z_OK);
    EXPECT_EQ(written, size);
    return bytes;
}

// Taken apart by zlib alone.
TEST(Png, WrittenFileHoldsTheIndicesAndThePaletteAsTheyAre) {
    constexpr std::size_t kWidth = 61, kHeight = 37;
    const PngBytes pixels = many_indices(kWidth * kHeight);
    PngBytes header, palette, packed;
    for (const PngChunk& chunk : chunks_of_png(encode_indexed_png(pixels, kWidth, kHeight, distinct_colours()))) {
        if (chunk.letters == "IHDR") header = chunk.data;
        if (chunk.letters == "PLTE") palette = chunk.data;
        if (chunk.letters == "IDAT") packed.insert(packed.end(), chunk.data.begin(), chunk.data.end());
        EXPECT_NE(chunk.letters, "tRNS");
    }
    EXPECT_EQ(header, png_header(kWidth, kHeight, 8, 3));
    ASSERT_EQ(palette.size(), 768u);
    for (std::size_t i = 0; i < 256; ++i)
        ASSERT_EQ((Rgb8{palette[i * 3], palette[i * 3 + 1], palette[i * 3 + 2]}), distinct_colours().colours[i]);
    const PngBytes rows = inflated(packed, (kWidth + 1) * kHeight);
    for (std::size_t y = 0; y < kHeight; ++y) {
        ASSERT_EQ(rows[y * (kWidth + 1)], 0) << "row " << y << " is filtered";
        for (std::size_t x = 0; x < kWidth; ++x)
            ASSERT_EQ(rows[y * (kWidth + 1) + 1 + x], pixels[y * kWidth + x]) << x << ' ' << y;
    }
}

TEST(Png, WhatIsWrittenReadsTheSame) {
    const PngBytes pixels = many_indices(48 * 5);
    const PngImage image = decode_png(encode_indexed_png(pixels, 48, 5, distinct_colours()));
    EXPECT_EQ(image.width_px, 48);
    EXPECT_EQ(image.height_px, 5);
    EXPECT_EQ(image.indices, pixels);
    ASSERT_EQ(image.colours.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(image.colours[i], (Rgba8{distinct_colours().colours[i], 255}));
}

TEST(Png, TheSameInputGivesTheSameFile) {
    const PngBytes pixels = many_indices(64 * 64);
    EXPECT_EQ(encode_indexed_png(pixels, 64, 64, distinct_colours()),
              encode_indexed_png(pixels, 64, 64, distinct_colours()));
}

TEST(Png, SizesThatDoNotAgreeAreRefused) {
    const PngBytes pixels(6);
    EXPECT_THROW(encode_indexed_png(pixels, 4, 2, {}), InputError);
    EXPECT_THROW(encode_indexed_png(pixels, -3, -2, {}), InputError);
    EXPECT_THROW(encode_indexed_png({}, 0, 0, {}), InputError);
}

TEST(Png, ShortPalettesAndFewBitsAPixelAreRead) {
    // Two bits a pixel: 0, 1, 2, 2 and 2, 1, 0, 0; the last colour is half transparent.
    const PngBytes file = png_of_rows(png_header(4, 2, 2, 3), {0, 0b00011010, 0, 0b10010000},
                                      {{"PLTE", {10, 20, 30, 40, 50, 60, 70, 80, 90}}, {"tRNS", {255, 255, 127}}});
    const PngImage image = decode_png(file);
    EXPECT_EQ(image.indices, (PngBytes{0, 1, 2, 2, 2, 1, 0, 0}));
    EXPECT_EQ(image.colours, (std::vector<Rgba8>{{{10, 20, 30}, 255}, {{40, 50, 60}, 255}, {{70, 80, 90}, 127}}));
    EXPECT_EQ(image.pixel(3), (Rgba8{{70, 80, 90}, 127}));
}

// The second row by the filter "up": differences to the row above.
TEST(Png, FilteredRowsAreReadAndOnlyPalettesHaveIndices) {
    EXPECT_EQ(decode_png(png_of_rows(png_header(1, 2, 8, 2), {0, 1, 2, 3, 2, 9, 8, 7})).colours,
              (std::vector<Rgba8>{{{1, 2, 3}}, {{10, 10, 10}}}));
    EXPECT_TRUE(decode_png(png_of_rows(png_header(1, 1, 8, 0), {0, 1})).indices.empty());
}

/// Sample `channel` of pixel (x, y), of 16 bits or fewer.
std::uint32_t sample_at(int x, int y, int channel, int depth) {
    const auto mixed = static_cast<std::uint32_t>((x * 7919 + y * 104'729 + channel * 31'337 + x * y * 77) & 0xffff);
    return mixed >> (16 - depth);
}

/// A file of each pixel's samples, by the seven passes of Adam7 (PNG specification, 8.2) or row by row. `behind`: bytes
/// deflated behind the rows.
PngBytes png_of_samples(int width, int height, int depth, int type, int channels, bool is_interlaced,
                        const std::vector<PngChunk>& more, const PngBytes& behind = {}) {
    struct Pass {
        int x, y, across, down;
    };
    const std::vector<Pass> adam7{{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                  {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}},
        plain{{0, 0, 1, 1}};
    PngBytes rows;
    for (const Pass& pass : is_interlaced ? adam7 : plain)
        for (int y = pass.y; y < height && pass.x < width; y += pass.down) {
            rows.push_back(0);
            std::uint32_t bits = 0;
            int count = 0;
            const auto put = [&](std::uint32_t value, int size) {
                for (int bit = size; bit-- > 0;) {
                    bits = bits << 1 | (value >> bit & 1);
                    if (++count % 8 == 0) rows.push_back(static_cast<std::uint8_t>(bits));
                }
            };
            for (int x = pass.x; x < width; x += pass.across)
                for (int channel = 0; channel < channels; ++channel) put(sample_at(x, y, channel, depth), depth);
            if (count % 8 != 0) put(0, 8 - count % 8);
        }
    PngBytes header = png_header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                                 static_cast<std::uint8_t>(depth), static_cast<std::uint8_t>(type));
    header.back() = is_interlaced ? 1 : 0;
    rows.insert(rows.end(), behind.begin(), behind.end());
    return png_of_rows(header, rows, more);
}

/// Of a gamma of `gamma`, by IEC 61966-2-1.
double srgb_of(double sample, double gamma) {
    const double light = std::pow(sample, 1 / gamma);
    return gamma == 0 ? sample : light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

TEST(Png, EveryKindHasItsPixelsInTheirPlaces) {
    struct Kind {
        int type, channels;
        std::vector<int> depths;
    };
    PngBytes palette, gamma_1;
    for (int i = 0; i < 768; ++i) palette.push_back(static_cast<std::uint8_t>(i * 37 + 5));
    append_big_endian(gamma_1, 100'000);
    for (const Kind& kind : {Kind{0, 1, {1, 2, 4, 8, 16}}, Kind{2, 3, {8, 16}}, Kind{3, 1, {1, 2, 4, 8}},
                             Kind{4, 2, {8, 16}}, Kind{6, 4, {8, 16}}})
        for (const int depth : kind.depths)
            for (const int choice : {0, 1, 2, 3}) {
                const bool is_interlaced = choice % 2 == 1;
                const double gamma = choice / 2, most = (1 << depth) - 1;
                std::vector<PngChunk> more;
                if (gamma > 0) more.push_back({"gAMA", gamma_1});
                const auto colours = std::ptrdiff_t{3} << depth;
                if (kind.type == 3) more.push_back({"PLTE", PngBytes(palette.begin(), palette.begin() + colours)});
                const PngImage image =
                    decode_png(png_of_samples(13, 11, depth, kind.type, kind.channels, is_interlaced, more));
                for (int y = 0; y < 11; ++y)
                    for (int x = 0; x < 13; ++x) {
                        const auto sample = [&](int channel) { return sample_at(x, y, channel, depth); };
                        const auto part = [&](int channel) {
                            return kind.type == 3 ? palette[sample(0) * 3 + static_cast<std::size_t>(channel)] / 255.0
                                                  : sample(kind.channels < 3 ? 0 : channel) / most;
                        };
                        const Rgba8 is = image.pixel(static_cast<std::size_t>(y * 13 + x));
                        const bool has_alpha = kind.type >= 4;
                        const double alpha = has_alpha ? sample(kind.channels - 1) / most * 255 : 255;
                        const auto seen = testing::Message()
                                          << kind.type << ' ' << depth << ' ' << choice << ": " << x << ' ' << y;
                        ASSERT_NEAR(is.colour.red, srgb_of(part(0), gamma) * 255, 0.51) << seen;
                        ASSERT_NEAR(is.colour.green, srgb_of(part(1), gamma) * 255, 0.51) << seen;
                        ASSERT_NEAR(is.colour.blue, srgb_of(part(2), gamma) * 255, 0.51) << seen;
                        ASSERT_NEAR(is.alpha, alpha, 0.51) << seen;
                    }
            }
}

std::string complaint_of(const PngBytes& file) {
    return refusal([&] { decode_png(file); });
}

TEST(Png, FaultsAreNamed) {
    EXPECT_TRUE(complaint_of({}).starts_with("image: not a readable PNG"));
    EXPECT_TRUE(complaint_of({'G', 'I', 'F', '8', '9', 'a', 0, 0}).starts_with("image: not a readable PNG"));
    EXPECT_TRUE(complaint_of(png_of_rows(png_header(4097, 1, 8, 0), {0})).starts_with("image: 4097x1 pixels"));
    EXPECT_TRUE(complaint_of(png_of_rows(png_header(8, 8, 8, 0), {0, 1})).starts_with("image: a damaged PNG"));
    const PngBytes beyond = png_of_rows(png_header(2, 1, 8, 3), {0, 0, 9}, {{"PLTE", {1, 2, 3}}});
    EXPECT_EQ(complaint_of(beyond), "image: a pixel of colour 9, expected one of the palette's 1");
}

TEST(Png, DataBehindTheRowsIsIgnoredUnlessThereIsMuchOfIt) {
    std::mt19937 random(1);
    PngBytes noise(1 << 17);
    std::generate(noise.begin(), noise.end(), random);
    const PngBytes little(noise.begin(), noise.begin() + 1000);
    for (const bool is_interlaced : {false, true}) {
        const auto file = [&](const PngBytes& behind) {
            return png_of_samples(130, 90, 8, 2, 3, is_interlaced, {}, behind);
        };
        EXPECT_EQ(decode_png(file(little)).colours, decode_png(file({})).colours);
        EXPECT_EQ(complaint_of(file(noise)), "image: a damaged PNG (libpng: too much data behind the picture's rows)");
    }
}

TEST(Png, NoPrefixOfAFileIsTakenForAWhole) {
    constexpr std::size_t kLastChunkBytes = 12;  // IEND says nothing
    expect_no_prefix_is_read(encode_indexed_png(many_indices(64), 8, 8, distinct_colours()), complaint_of,
                             kLastChunkBytes);
}

}  // namespace
}  // namespace oblong::test::png_test
