#pragma once

#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

// PNG files by hand, without the library that the programs use: signature, then chunks of length, four letters, data
// and CRC, numbers big-endian (PNG specification, second edition).
namespace oblong::test {

using PngBytes = std::vector<std::uint8_t>;
inline const PngBytes kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

inline void append_big_endian(PngBytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

inline std::uint32_t big_endian_at(const PngBytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes.at(at + i);
    return value;
}

struct PngChunk {
    std::string letters;
    PngBytes data;
};

inline PngBytes png_of_chunks(const std::vector<PngChunk>& chunks) {
    PngBytes file = kPngSignature;
    for (const PngChunk& chunk : chunks) {
        append_big_endian(file, static_cast<std::uint32_t>(chunk.data.size()));
        const std::size_t start = file.size();
        file.insert(file.end(), chunk.letters.begin(), chunk.letters.end());
        file.insert(file.end(), chunk.data.begin(), chunk.data.end());
        append_big_endian(file, static_cast<std::uint32_t>(crc32_z(0, &file[start], file.size() - start)));
    }
    return file;
}

inline std::vector<PngChunk> chunks_of_png(const PngBytes& file) {
    std::vector<PngChunk> chunks;
    for (std::size_t at = kPngSignature.size(); at < file.size();) {
        const auto length = static_cast<std::ptrdiff_t>(big_endian_at(file, at));
        const auto data = file.begin() + static_cast<std::ptrdiff_t>(at) + 8;
        chunks.push_back({std::string(data - 4, data), PngBytes(data, data + length)});
        at += static_cast<std::size_t>(length) + 12;
    }
    return chunks;
}

inline PngBytes png_header(std::uint32_t width, std::uint32_t height, std::uint8_t depth, std::uint8_t colour_type) {
    PngBytes data;
    append_big_endian(data, width);
    append_big_endian(data, height);
    data.insert(data.end(), {depth, colour_type, 0, 0, 0});
    return data;
}

inline PngBytes deflated(const PngBytes& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    PngBytes packed(size);
    if (compress(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size())) != Z_OK)
        throw std::runtime_error("zlib failed");
    packed.resize(size);
    return packed;
}

/// `rows`: of each row its filter's number (0: none) and its samples. `more`: chunks between header and picture.
inline PngBytes png_of_rows(const PngBytes& header, const PngBytes& rows, const std::vector<PngChunk>& more = {}) {
    std::vector<PngChunk> chunks{{"IHDR", header}};
    chunks.insert(chunks.end(), more.begin(), more.end());
    chunks.push_back({"IDAT", deflated(rows)});
    chunks.push_back({"IEND", {}});
    return png_of_chunks(chunks);
}

}  // namespace oblong::test
