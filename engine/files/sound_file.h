#pragma once

#include <cstdint>
#include <span>

#include "engine/files/flac.h"

namespace oblong {

/// Decodes a sound of one channel: FLAC as decode_flac() reads it, or WAV (RIFF) with PCM of 8 or 16 bits. Throws
/// InputError with the offset of the error.
SoundSamples decode_sound(std::span<const std::uint8_t> file);

}  // namespace oblong
