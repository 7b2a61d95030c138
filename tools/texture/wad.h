#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// A WAD2 file of textures: "WAD2", count, offset of the directory; each lump is a miptex (name of 16 bytes, width,
/// height, four offsets from its own beginning, then the four mip levels); directory entries are offset, size on disk,
/// size, type 'D', no compression, name of 16 bytes. Little-endian throughout.
std::vector<std::uint8_t> write_wad(std::span<const MipTexture> textures);

/// The textures of a WAD2 or a Quake BSP (29, BSP2 or 2PSB), in the file's order, those with no texels left out. Throws
/// InputError where a size or an offset leads out of the file.
std::vector<MipTexture> read_textures(std::span<const std::uint8_t> file);

}  // namespace oblong
