#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/files/level_models.h"

// A level's models as they are in memory after reading, for who has neither the libraries nor the time to read OBJ and
// PNG files: the DOS build's LEVEL.models, beside LEVEL.bsp. Without warnings, and without the names of frames and
// skins.

namespace oblong {

std::vector<std::uint8_t> encode_level_models(const LevelModels& models);

/// Throws InputError for bytes that end too early, or are too many.
LevelModels decode_level_models(std::span<const std::uint8_t> bytes);

}  // namespace oblong
