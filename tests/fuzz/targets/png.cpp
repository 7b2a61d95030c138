// PNG files, made of the input's bytes as their chunks, so that checksums and sizes are right; and as they are.

#include <algorithm>

#include "engine/files/picture.h"
#include "engine/view/screen.h"
#include "tests/files/png_writer.h"
#include "tests/fuzz/common/played_level.h"

namespace oblong::fuzz {
namespace {

constexpr const char* kChunks[] = {"IDAT", "PLTE", "tRNS", "gAMA", "sRGB", "cHRM", "sBIT", "bKGD",
                                   "iCCP", "tEXt", "pHYs", "IEND", "IHDR", "IDAT", "IDAT", "zTXt"};

// Sizes of its two first bytes, depth, colour type and interlacing of the third and fourth; then chunks: a letter, a
// size, and so many bytes. Those of IDAT are deflated, all others as they are.
Bytes made_png(Input input) {
    test::PngBytes header;
    test::append_big_endian(header, input[0] % 40u);
    test::append_big_endian(header, input[1] % 40u);
    const auto depth = static_cast<std::uint8_t>(input[2] % 8 < 5 ? 1 << input[2] % 8 : input[2]);
    header.insert(header.end(),
                  {depth, static_cast<std::uint8_t>(input[3] % 8), 0, 0, static_cast<std::uint8_t>(input[3] >> 7)});
    std::vector<test::PngChunk> chunks{{"IHDR", header}};
    std::size_t at = 4;
    while (at + 2 < input.size()) {
        const Input data = input.subspan(at + 2, std::min<std::size_t>(input[at + 1] * 4u, input.size() - at - 2));
        const std::string letters = kChunks[input[at] % std::size(kChunks)];
        Bytes bytes(data.begin(), data.end());
        const bool is_raw = (input[at] & 0x80) != 0;
        chunks.push_back({letters, letters == "IDAT" && !is_raw ? test::deflated(bytes) : bytes});
        at += 2 + data.size();
    }
    chunks.push_back({"IEND", {}});
    return test::png_of_chunks(chunks);
}

void check(const PngImage& image) {
    const std::size_t pixels = pixel_count(image.width_px, image.height_px);
    expect((image.indices.empty() ? image.colours.size() : image.indices.size()) == pixels, "as many pixels");
    if (image.indices.empty()) return;
    expect(image.colours.size() <= 256, "a palette of 256 colours at most");
    const PngImage again = decode_png(encode_indexed_png(image.indices, image.width_px, image.height_px, greys()));
    expect(again.indices == image.indices, "the indices that were written");
}

}  // namespace

void run(Input input) {
    if (input.size() < 4) return;
    const bool is_file = std::equal(input.begin(), input.begin() + 4, test::kPngSignature.begin());
    check(decode_picture(is_file ? Bytes(input.begin(), input.end()) : made_png(input)));
}

}  // namespace oblong::fuzz
