#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The sounds and the music of the game, made out of nothing but this source.
namespace oblong::sound_source {

struct NamedSound {
    std::string name;  ///< of the file, without ".wav"
    std::vector<std::int16_t> samples;
};

/// All of them, at synth::kRate_hz.
std::vector<NamedSound> make_all_sounds();

// Its parts.
std::vector<NamedSound> make_steps();
std::vector<NamedSound> make_movers();
std::vector<NamedSound> make_water();
std::vector<NamedSound> make_signals();
std::vector<NamedSound> make_ambience();

/// The file: RIFF, 16 bits, one channel.
std::vector<std::uint8_t> encode_wave(const std::vector<std::int16_t>& samples);

/// The title's music, a ProTracker module of eight channels.
std::vector<std::uint8_t> make_title_music();

}  // namespace oblong::sound_source
