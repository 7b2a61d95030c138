#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace oblong {

/// The contents of a sound file: one channel of 16 bits.
struct SoundSamples {
    std::int32_t rate_hz = 0;
    std::vector<std::int16_t> samples;
};

/// Decodes a FLAC file (RFC 9639) of one channel and 16 bits a sample, with integers only. Throws InputError with the
/// offset of the error: a damaged frame (each has a checksum), more channels, no samples.
SoundSamples decode_flac(std::span<const std::uint8_t> file);

/// Decodes a sound of one channel: FLAC as decode_flac() reads it, or WAV (RIFF) with PCM of 8 or 16 bits. Throws
/// InputError with the offset of the error.
SoundSamples decode_sound(std::span<const std::uint8_t> file);

}  // namespace oblong
