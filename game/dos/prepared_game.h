#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/t_junctions.h"
#include "game/level/load.h"

// A level as it is in memory after loading: the DOS build's LEVEL.ready, beside LEVEL.bsp. DOS has not the libraries to
// load models and pictures, and a 486 takes too long. Warnings and the names of frames and skins are left out.

namespace oblong {

/// The hash of the level, its colormap and its models.
std::vector<std::uint8_t> encode_prepared_game(const GameData& data);

/// Fills those. Throws InputError for bytes that end too early, or are too many.
void decode_prepared_game(std::span<const std::uint8_t> bytes, GameData& data);

/// Each edge's vertices: how many, and which.
std::vector<std::uint8_t> encode_t_junctions(const Level& level, const TJunctions& junctions);

}  // namespace oblong
