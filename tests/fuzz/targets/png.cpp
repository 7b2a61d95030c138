// PNG files, made of the input's bytes as their chunks, so that checksums and sizes are right; and as they are.

#include <algorithm>

#include "engine/base/checksum.h"
#include "engine/pictures/picture.h"
#include "engine/view/screen.h"
#include "tests/files/png_writer.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/bsp_writer.h"

namespace oblong::fuzz {
namespace {

constexpr const char* kChunks[] = {"IDAT", "PLTE", "tRNS", "gAMA", "sRGB", "cHRM", "sBIT", "bKGD",
                                   "iCCP", "tEXt", "pHYs", "IEND", "IHDR", "IDAT", "IDAT", "zTXt"};

// zlib's format without compression, which takes less time than all else.
Bytes stored(const Bytes& bytes) {
    Bytes packed{0x78, 0x01};
    constexpr std::size_t kMost = 0xffff;
    for (std::size_t at = 0; at == 0 || at < bytes.size(); at += kMost) {
        const std::size_t size = std::min(kMost, bytes.size() - at);
        packed.push_back(at + size == bytes.size());
        test::ByteWriter(packed).number(2, static_cast<std::int64_t>(size)).number(2, ~static_cast<std::int64_t>(size));
        packed.insert(packed.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    }
    test::append_big_endian(packed, static_cast<std::uint32_t>(adler32_z(1, bytes.data(), bytes.size())));
    return packed;
}

struct Header {
    std::uint32_t width, height;
    std::uint8_t depth, colour_type;
    bool is_interlaced;
};

// The rows of a picture from bytes that are too few: they repeat, and each row begins with the number of a filter.
Bytes filled_rows(const Header& header, const Bytes& bytes) {
    constexpr std::uint32_t kChannels[] = {1, 1, 3, 1, 2, 1, 4, 1}, kFilters = 5;
    const std::size_t row = 1 + (std::size_t{header.width} * header.depth * kChannels[header.colour_type] + 7) / 8;
    Bytes rows(row * header.height);
    for (std::size_t i = 0; i < rows.size() && !bytes.empty(); ++i) rows[i] = bytes[i % bytes.size()];
    for (std::size_t i = 0; i < rows.size(); i += row) rows[i] %= kFilters;
    return rows;
}

// Sizes of its two first bytes, depth, colour type and interlacing of the third and fourth; then chunks: a letter,
// a size, and so many bytes. Those of IDAT are packed as zlib has it, or they are as they stand; all others are.
Bytes made_png(Input input) {
    const Header header{input[0] % 40u, input[1] % 40u,
                        static_cast<std::uint8_t>(input[2] % 8 < 5 ? 1 << input[2] % 8 : input[2]),
                        static_cast<std::uint8_t>(input[3] % 8), input[3] >= 0x80};
    test::PngBytes bytes_of_header = test::png_header(header.width, header.height, header.depth, header.colour_type);
    bytes_of_header.back() = header.is_interlaced;
    std::vector<test::PngChunk> chunks{{"IHDR", bytes_of_header}};
    std::size_t at = 4;
    while (at + 2 < input.size()) {
        const Input data = input.subspan(at + 2, std::min<std::size_t>(input[at + 1] * 4u, input.size() - at - 2));
        const std::string letters = kChunks[input[at] % std::size(kChunks)];
        const int kind = letters == "IDAT" ? input[at] >> 6 : 3;
        Bytes bytes(data.begin(), data.end());
        if (kind < 2) bytes = filled_rows(header, bytes);
        chunks.push_back({letters, kind == 3 ? bytes : stored(bytes)});
        at += 2 + data.size();
    }
    chunks.push_back({"IEND", {}});
    return test::png_of_chunks(chunks);
}

void check(const PngImage& image) {
    const std::size_t pixels = pixel_count(image.width_px, image.height_px);
    note_reached(image.indices.empty() ? "colours" : "indices");
    expect((image.indices.empty() ? image.colours.size() : image.indices.size()) == pixels, "as many pixels");
    if (image.indices.empty() || fnv1a_of(image.indices) % 16 != 0) return;  // writing takes ten times as long
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
