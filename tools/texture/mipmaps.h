#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "engine/surface/palette.h"

namespace oblong {

/// A texture with its four mip levels. A texel of level n is the palette colour nearest to the mean of the 2^n x 2^n
/// texels of level 0 under it: a glowing colour if half of them or more glow, and else an ordinary one, so that
/// nothing starts to glow with distance. Where the texture has holes, such a texel is one if half of those under it
/// are, and else the mean of the others. `texels` are width * height; both sizes are multiples of 16.
MipTexture make_mip_texture(const std::string& name, std::int32_t width, std::int32_t height,
                            std::vector<std::uint8_t> texels, const Palette& palette);

/// In textures whose names begin with '{' the last colour is not drawn: a hole.
inline constexpr std::uint8_t kHole = 255;
inline bool has_holes(std::string_view texture_name) {
    return texture_name.starts_with('{');
}

}  // namespace oblong
