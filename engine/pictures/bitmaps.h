#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/base/input_error.h"
#include "engine/base/little_endian.h"
#include "engine/pictures/picture.h"
#include "engine/view/screen.h"

// Shared by the decoders of pictures.
namespace oblong {

inline constexpr std::int32_t kLargestPictureSide_px = 4096;

[[noreturn]] inline void refuse_picture(const std::string& what_is_wrong) {
    throw InputError("image", what_is_wrong);
}

/// Throws InputError unless a picture's sides are in range.
inline void check_picture_size(std::int64_t width_px, std::int64_t height_px) {
    if (width_px < 1 || height_px < 1 || width_px > kLargestPictureSide_px || height_px > kLargestPictureSide_px)
        refuse_picture(std::to_string(width_px) + "x" + std::to_string(height_px) + " pixels, expected 1 to " +
                       std::to_string(kLargestPictureSide_px) + " a side");
}

/// Throws InputError unless so many pixels are to be written as a picture's sides say.
inline void check_pixels_to_write(std::size_t pixels, std::int32_t width_px, std::int32_t height_px) {
    if (width_px <= 0 || height_px <= 0 || pixels != pixel_count(width_px, height_px))
        refuse_picture(std::to_string(pixels) + " pixels of " + std::to_string(width_px) + "x" +
                       std::to_string(height_px) + ", expected all, and one or more a side");
}

inline std::span<const std::uint8_t> take_of_picture(LittleEndianReader& in, std::size_t count) {
    if (count > in.rest()) refuse_picture("the file ends within the picture, expected all of it");
    return in.take(count);
}

/// A colour of a picture's palette. Throws InputError if it has none of this number.
inline Rgba8 palette_colour(std::span<const Rgba8> palette, std::int64_t number) {
    if (number < 0 || number >= std::ssize(palette))
        refuse_picture("a pixel of colour " + std::to_string(number) + ", expected " +
                       (palette.empty() ? "a palette" : "one of the palette's " + std::to_string(palette.size())));
    return palette[static_cast<std::size_t>(number)];
}

/// A part of a colour of few bits, `most` at its brightest, as one of 8 bits.
constexpr std::uint8_t of_8_bits(std::uint64_t value, std::uint64_t most) {
    return static_cast<std::uint8_t>(most == 0 ? 0 : value * 255 / most);
}

/// A BMP of Windows or OS/2 that is not compressed: 1, 2, 4, 8 bits with a palette, 16 and 32 bits of any masks, 24.
PngImage decode_bmp(std::span<const std::uint8_t> file);

/// Whether bytes may be a TGA, which no letters mark.
bool may_be_tga(std::span<const std::uint8_t> file);

/// A TGA of any kind (Truevision 1989), compressed or not, from any of its four corners, with its rows in order.
PngImage decode_tga(std::span<const std::uint8_t> file);

}  // namespace oblong
