#pragma once

#include <string>

#include "engine/scene/face_surface.h"
#include "tests/support/levels.h"

namespace oblong::test {

/// Adds a texture of one colour, 16 x 16 texels unless told otherwise.
inline TextureIndex add_texture(Level& level, const std::string& name, std::uint8_t colour = 7,
                                std::int32_t width = 16) {
    MipTexture texture{name, width, 16, {}, false};
    for (int mip = 0; mip < 4; ++mip)
        texture.mips[static_cast<std::size_t>(mip)].assign(static_cast<std::size_t>((width >> mip) * (16 >> mip)),
                                                           colour);
    level.textures.push_back(texture);
    return TextureIndex(level.textures.count() - 1);
}

/// A colormap that shows nothing but a texel's own colour in the brightest shade, and the shade in all others.
inline Colormap plain_colormap() {
    Colormap map;
    for (std::size_t shade = 0; shade < map.shades.size(); ++shade)
        for (std::size_t colour = 0; colour < 256; ++colour)
            map.shades[shade][colour] = static_cast<std::uint8_t>(shade == 0 ? colour : shade);
    return map;
}

}  // namespace oblong::test
