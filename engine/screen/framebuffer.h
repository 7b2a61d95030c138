#pragma once

#include <cstdint>

namespace oblong {

/// A view of an 8-bit canvas that somebody else owns: rows top to bottom, `pitch` bytes apart, one palette index a
/// pixel.
struct Framebuffer {
    std::uint8_t* pixels = nullptr;
    std::int32_t width_px = 0, height_px = 0, pitch = 0;

    std::uint8_t* row(std::int32_t y) const { return pixels + static_cast<std::int64_t>(y) * pitch; }
};

}  // namespace oblong
