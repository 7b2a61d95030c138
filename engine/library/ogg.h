#pragma once

#include <cstdint>
#include <span>

#include "engine/sound/sound_file.h"

namespace oblong {

/// Whether bytes begin as an Ogg file does.
bool is_ogg(std::span<const std::uint8_t> file);

/// Decodes an Ogg Vorbis file (by stb_vorbis) and mixes its channels to one. Throws InputError for another or a damaged
/// one, or one without samples. Only for a program's own files: the decoder is not proof against malice.
SoundSamples decode_ogg(std::span<const std::uint8_t> file);

}  // namespace oblong
