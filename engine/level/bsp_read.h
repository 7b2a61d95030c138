#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Reads a BSP 29, BSP2 or 2PSB file, and converts floats to the engine's fixed point. For any bytes the result is
/// either a Level in which every index, tree, offset and number has been checked, and faces are clockwise on their
/// planes, or an InputError whose `where` names the lump and the offset in the file ("lump 'planes', offset 1234").
/// Allocates at most a small multiple of the file's size.
///
/// Tolerated: textures without texels or of a size that cannot be drawn (replaced by a checkerboard); lightmap offsets
/// in a level without lighting, and visibility offsets in one without visibility (both ignored).
Level read_bsp(std::span<const std::uint8_t> bytes);

/// The colours of a level's light from the bytes of a .lit file, which some compilers write beside it: "QLIT", version
/// 1, then three bytes for each of Level::lighting. Throws InputError if it is not of this level.
void read_lit_file(std::span<const std::uint8_t> bytes, Level& level);

/// A warning for each texture that a checkerboard replaces.
std::vector<std::string> texture_warnings(const Level& level);

/// Reads the textures only; the rest of the file may be damaged.
std::vector<MipTexture> read_bsp_textures(std::span<const std::uint8_t> bytes);

}  // namespace oblong
