#pragma once

#include "engine/files/png.h"

namespace oblong {

/// A picture that a mapper's editor wrote: a PNG as decode_png() reads it, or a TGA, JPEG or BMP, 4096 pixels a side at
/// most, as a colour a pixel (a palette of theirs is not kept). Throws InputError for bytes that are none of these, or
/// of which a part is missing or damaged.
PngImage decode_picture(std::span<const std::uint8_t> file);

}  // namespace oblong
