#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Throws InputError at `where` unless both sizes, in texels, are multiples of 16 from 16 to 4096.
void check_texture_size(std::int64_t width, std::int64_t height, const std::string& where);

/// A texture in the bytes of a WAD2.
struct WadTexture {
    std::string name;
    std::span<const std::uint8_t> miptex;  ///< its header of 40 bytes and what follows, as BSP files hold it too
};

/// The textures of a WAD2, in the file's order; it points into `file`. Throws InputError where a size or an offset
/// leads out of the file; those of a texture are added to `faults` instead, if that is given, and leave it out.
std::vector<WadTexture> read_wad(std::span<const std::uint8_t> file, std::vector<std::string>* faults = nullptr);

/// Whether a texture's miptex has the name that the directory finds it by, but for case. Some tools leave it empty.
bool has_own_name(const WadTexture& texture);

/// A miptex: name of 16 bytes, width, height, four offsets from its own beginning, then the four mip levels. Throws
/// InputError for sizes that are no multiples of 16 up to 4096, or texels outside of it.
MipTexture parse_miptex(std::span<const std::uint8_t> miptex);

/// A WAD2 file of textures: "WAD2", count, offset of the directory; a miptex each; directory entries are offset, size
/// on disk, size, type 'D', no compression, name of 16 bytes. Little-endian throughout.
std::vector<std::uint8_t> write_wad(std::span<const MipTexture> textures);

}  // namespace oblong
