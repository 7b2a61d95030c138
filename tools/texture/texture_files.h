#pragma once

#include <string>
#include <vector>

#include "engine/level/level.h"
#include "engine/surface/palette.h"

namespace oblong {

/// All these throw FileError.

/// A PNG as a texture named after the file. Its sizes must be multiples of 16, 4096 at most.
MipTexture read_png_texture(const std::string& path, const Palette& palette);

/// `pack`: PNGs into a WAD.
void pack_textures(const std::vector<std::string>& png_paths, const std::string& wad_path, const Palette& palette);

/// `unpack`: the textures of a WAD or a BSP as indexed PNGs into a folder, which is made.
void unpack_textures(const std::string& archive_path, const std::string& folder, const Palette& palette);

}  // namespace oblong
