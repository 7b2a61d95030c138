#include "tools/png/indexed_png.h"

#include <zlib.h>

#include <array>
#include <string>
#include <string_view>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append_u32_big_endian(Bytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// A chunk: length of the data, four letters, data, and a CRC of letters and data.
void append_chunk(Bytes& file, std::string_view letters, const Bytes& data) {
    append_u32_big_endian(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t crc_begin = file.size();
    file.insert(file.end(), letters.begin(), letters.end());
    file.insert(file.end(), data.begin(), data.end());
    const uLong crc = crc32_z(0, file.data() + crc_begin, file.size() - crc_begin);
    append_u32_big_endian(file, static_cast<std::uint32_t>(crc));
}

Bytes header(std::int32_t width_px, std::int32_t height_px) {
    Bytes data;
    append_u32_big_endian(data, static_cast<std::uint32_t>(width_px));
    append_u32_big_endian(data, static_cast<std::uint32_t>(height_px));
    constexpr std::array<std::uint8_t, 5> kDepthColourCompressionFilterInterlace{8, 3, 0, 0, 0};
    data.insert(data.end(), kDepthColourCompressionFilterInterlace.begin(),
                kDepthColourCompressionFilterInterlace.end());
    return data;
}

Bytes palette_triples(const Palette& palette) {
    Bytes data;
    for (const Rgb8& colour : palette.colours) data.insert(data.end(), {colour.red, colour.green, colour.blue});
    return data;
}

/// Each row with a filter byte before it (0: none, which suits palette indices), deflated.
Bytes deflated_rows(std::span<const std::uint8_t> pixels, std::size_t width_px) {
    Bytes rows;
    for (std::size_t at = 0; at < pixels.size(); at += width_px) {
        rows.push_back(0);
        const auto row = pixels.subspan(at, width_px);
        rows.insert(rows.end(), row.begin(), row.end());
    }
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    Bytes packed(size);
    if (compress2(packed.data(), &size, rows.data(), static_cast<uLong>(rows.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
        throw InputError("png", "zlib could not compress the picture");
    }
    packed.resize(size);
    return packed;
}

}  // namespace

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette) {
    const bool is_sane = width_px > 0 && height_px > 0;
    if (!is_sane || pixels.size() != static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {
        throw InputError("png", std::to_string(pixels.size()) + " pixels given for a picture of " +
                                    std::to_string(width_px) + "x" + std::to_string(height_px));
    }
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(file, "IHDR", header(width_px, height_px));
    append_chunk(file, "PLTE", palette_triples(palette));
    append_chunk(file, "IDAT", deflated_rows(pixels, static_cast<std::size_t>(width_px)));
    append_chunk(file, "IEND", {});
    return file;
}

}  // namespace oblong
