#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/surface/palette.h"

namespace oblong {

/// The bytes of a PNG file of colour type 3 (8-bit palette) that holds `pixels` (rows top to bottom, one palette index
/// each, exactly width_px * height_px of them) as they are. The same input gives the same file. Throws InputError where
/// the sizes do not agree.
std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette);

/// What an indexed PNG holds.
struct IndexedPng {
    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::uint8_t> pixels;
    Palette palette;
};

/// The indices of an 8-bit palette PNG without interlacing, or nothing if the bytes are anything else (or broken).
/// Checksums are not checked.
std::optional<IndexedPng> decode_indexed_png(std::span<const std::uint8_t> file);

}  // namespace oblong
