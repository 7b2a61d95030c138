#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/t_junctions.h"
#include "game/level/load.h"

// A level's data after loading: in the DOS build in place of LEVEL.bsp. DOS lacks the libraries to load
// models and pictures, and a 486 takes seconds to check a level. Warnings and the names of frames and skins are left
// out.

namespace oblong {

/// Writes the level, its hash, its colormap and its models.
std::vector<std::uint8_t> encode_prepared_game(const GameData& data);

/// Reads the same. Throws InputError for bytes that end too early, or are too many.
void decode_prepared_game(std::span<const std::uint8_t> bytes, GameData& data);

/// For each edge, the number of its vertices and their indices.
std::vector<std::uint8_t> encode_t_junctions(const Level& level, const TJunctions& junctions);

}  // namespace oblong
