#include "tools/png/indexed_png.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include "engine/base/input_error.h"

namespace oblong {
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

TEST(IndexedPng, AnotherDecoderReadsTheSameColours) {
    const Palette palette = distinct_colours();
    constexpr int kWidth = 61, kHeight = 37;
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < kWidth * kHeight; ++i) pixels.push_back(static_cast<std::uint8_t>(i * i / 7));
    const auto file = encode_indexed_png(pixels, kWidth, kHeight, palette);

    int width = 0, height = 0, channels = 0;
    stbi_uc* rgb = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels, 3);
    ASSERT_NE(rgb, nullptr) << stbi_failure_reason();
    EXPECT_EQ(width, kWidth);
    EXPECT_EQ(height, kHeight);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Rgb8 read{rgb[i * 3], rgb[i * 3 + 1], rgb[i * 3 + 2]};
        ASSERT_EQ(read, palette.colours[pixels[i]]) << "pixel " << i;
    }
    stbi_image_free(rgb);
}

TEST(IndexedPng, DecodesToTheSameIndices) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 48 * 5; ++i) pixels.push_back(static_cast<std::uint8_t>(i * 37));
    const auto decoded = decode_indexed_png(encode_indexed_png(pixels, 48, 5, distinct_colours()));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->width_px, 48);
    EXPECT_EQ(decoded->height_px, 5);
    EXPECT_EQ(decoded->pixels, pixels);
    EXPECT_EQ(decoded->palette.colours, distinct_colours().colours);
}

TEST(IndexedPng, NoPrefixOfAFileDecodes) {
    const std::vector<std::uint8_t> pixels(64, 9);
    const auto file = encode_indexed_png(pixels, 8, 8, distinct_colours());
    constexpr std::size_t kLastChunkBytes = 12;  // IEND says nothing
    for (std::size_t size = 0; size < file.size() - kLastChunkBytes; ++size) {
        EXPECT_FALSE(decode_indexed_png(std::span(file).first(size))) << size;
    }
}

TEST(IndexedPng, SaysInItsHeaderThatItIsIndexed) {
    const std::vector<std::uint8_t> pixels(6, 5);
    const auto file = encode_indexed_png(pixels, 3, 2, distinct_colours());
    // Signature 8, length 4, "IHDR" 4, width 4, height 4: then bit depth and colour type.
    EXPECT_EQ(file[24], 8);
    EXPECT_EQ(file[25], 3);
}

TEST(IndexedPng, SizesThatDoNotAgreeAreRefused) {
    const std::vector<std::uint8_t> pixels(6);
    EXPECT_THROW(encode_indexed_png(pixels, 4, 2, {}), InputError);
    EXPECT_THROW(encode_indexed_png(pixels, -3, -2, {}), InputError);
    EXPECT_THROW(encode_indexed_png({}, 0, 0, {}), InputError);
}

}  // namespace
}  // namespace oblong
