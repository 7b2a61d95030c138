#pragma once

#include <cstdint>
#include <span>

#include "engine/level/level.h"

namespace oblong {

/// The level in a file of BSP 29, BSP2 or 2PSB, its floats in the engine's fixed point. Whatever the bytes: either a
/// Level in which every index, tree, offset and number has been checked, or an InputError whose `where` names the lump
/// and the offset in the file ("lump 'planes', offset 1234"). Allocates no more than a small multiple of the file.
///
/// Tolerated: a texture without texels (a checkerboard replaces it); lightmap offsets where the level has no light, and
/// visibility offsets where it has no visibility (as if there were none).
Level read_bsp(std::span<const std::uint8_t> bytes);

/// Its textures alone: the rest of the file may be damaged.
std::vector<MipTexture> read_bsp_textures(std::span<const std::uint8_t> bytes);

}  // namespace oblong
