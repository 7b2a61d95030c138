#include <SDL.h>
#include <SDL_mixer.h>

#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/platform/sdl/sdl.h"
#include "engine/platform/sdl/voice_filter.h"

namespace oblong {
namespace {

constexpr int kRate_hz = 44'100, kBuffer_samples = 1024, kVoices = 32, kFade_ms = 60;

struct FreeMixer {
    void operator()(Mix_Chunk* chunk) const { Mix_FreeChunk(chunk); }
    void operator()(Mix_Music* music) const { Mix_FreeMusic(music); }
};
template <class T>
using OwnedSound = std::unique_ptr<T, FreeMixer>;

/// As the device plays it; the chunk points into the bytes.
struct ConvertedSound {
    std::vector<std::uint8_t> bytes;
    OwnedSound<Mix_Chunk> chunk;
};

[[noreturn]] void fail() {
    throw std::runtime_error(std::string("no sound: ") + Mix_GetError());
}

// Bytes are read where they are: what reads them later must not outlive them.
SDL_RWops* reader_of(std::span<const std::uint8_t> bytes) {
    if (bytes.empty() || bytes.size() > std::size_t{std::numeric_limits<int>::max()})
        throw InputError("offset 0", "has " + std::to_string(bytes.size()) + " bytes, expected a sound");
    return SDL_RWFromConstMem(bytes.data(), static_cast<int>(bytes.size()));
}

void apply_filter(int, void* stream, int length_bytes, void* filter) {
    const std::size_t count = as_size(length_bytes) / sizeof(std::int16_t);
    static_cast<VoiceFilter*>(filter)->apply({static_cast<std::int16_t*>(stream), count});
}

using AlsaErrorHandler = void (*)(const char* file, int line, const char* function, int error, const char* format, ...);

void ignore_alsa_error(const char*, int, const char*, int, const char*, ...) {}

// Where there is no sound card, ALSA's library writes a dozen lines on standard error by itself: the game says it in
// one.
void silence_alsa() {
    void* library = SDL_LoadObject("libasound.so.2");
    if (library == nullptr) return;
    using SetHandler = int (*)(AlsaErrorHandler);
    const auto set_handler = reinterpret_cast<SetHandler>(SDL_LoadFunction(library, "snd_lib_error_set_handler"));
    if (set_handler != nullptr) set_handler(ignore_alsa_error);
}

// Everything is converted to one format: the filters know no other.
struct Device {
    Device() {
        silence_alsa();
        if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) fail();
        if (Mix_OpenAudioDevice(kRate_hz, AUDIO_S16SYS, VoiceFilter::kSides, kBuffer_samples, nullptr, 0) == 0) return;
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
        fail();
    }
    ~Device() {
        Mix_CloseAudio();
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
};

class Mixer final : public SoundOutput {
  public:
    Mixer() { Mix_AllocateChannels(kVoices); }
    ~Mixer() override {
        Mix_HaltChannel(-1);
        Mix_HaltMusic();
    }

    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override;
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override;
    bool is_playing(VoiceNumber voice) const override { return channel_of(voice) >= 0; }
    void adjust(VoiceNumber voice, const VoiceLevels& levels) override;
    void stop(VoiceNumber voice) override;
    void hold_voices(bool are_held) override { are_held ? Mix_Pause(-1) : Mix_Resume(-1); }
    void play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) override;
    void set_music_volume(std::int32_t volume_256) override { Mix_VolumeMusic(volume_256 * MIX_MAX_VOLUME / 256); }
    void stop_music() override { music_.reset(); }

  private:
    int channel_of(VoiceNumber voice) const;

    Device device_;  // first: it outlives the rest
    std::array<VoiceFilter, kVoices> filters_;
    std::array<VoiceNumber, kVoices> last_voices_{};  // by channel: the last one that was started there
    VoiceNumber next_voice_ = 0;
    std::vector<ConvertedSound> sounds_;
    std::vector<std::uint8_t> music_bytes_;
    OwnedSound<Mix_Music> music_;
};

SoundOutput::SoundNumber Mixer::add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) {
    SDL_AudioCVT conversion;
    if (SDL_BuildAudioCVT(&conversion, AUDIO_S16SYS, 1, rate_hz, AUDIO_S16SYS, VoiceFilter::kSides, kRate_hz) < 0)
        fail();
    const std::size_t size_bytes = samples.size_bytes();
    ConvertedSound sound{std::vector<std::uint8_t>(size_bytes * as_size(conversion.len_mult)), {}};
    std::memcpy(sound.bytes.data(), samples.data(), size_bytes);
    conversion.buf = sound.bytes.data();
    conversion.len = static_cast<int>(size_bytes);
    if (SDL_ConvertAudio(&conversion) != 0) fail();
    sound.bytes.resize(as_size(conversion.len_cvt));
    sound.bytes.shrink_to_fit();
    sound.chunk.reset(Mix_QuickLoad_RAW(sound.bytes.data(), static_cast<Uint32>(conversion.len_cvt)));
    if (!sound.chunk) fail();
    sounds_.push_back(std::move(sound));
    return static_cast<SoundNumber>(sounds_.size()) - 1;
}

// The channel in which a voice is playing; -1: it has ended.
int Mixer::channel_of(VoiceNumber voice) const {
    for (int channel = 0; channel < kVoices; ++channel)
        if (item(last_voices_, channel) == voice && Mix_Playing(channel) != 0) return channel;
    return -1;
}

SoundOutput::VoiceNumber Mixer::start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) {
    for (int channel = 0; channel < kVoices; ++channel) {
        if (Mix_Playing(channel) != 0) continue;
        const auto i = as_size(channel);
        filters_[i].begin(levels, is_loop);
        // A voice that has ended has lost its filter: SDL_mixer removes it.
        Mix_RegisterEffect(channel, apply_filter, nullptr, &filters_[i]);
        Mix_PlayChannel(channel, sounds_.at(as_size(sound)).chunk.get(), is_loop ? -1 : 0);
        return last_voices_[i] = next_voice_++;
    }
    return kNoVoice;
}

void Mixer::adjust(VoiceNumber voice, const VoiceLevels& levels) {
    const int channel = channel_of(voice);
    if (channel >= 0) item(filters_, channel).set(levels);
}

void Mixer::stop(VoiceNumber voice) {
    const int channel = channel_of(voice);
    if (channel >= 0) Mix_FadeOutChannel(channel, kFade_ms);
}

void Mixer::play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) {
    music_.reset();
    music_bytes_.assign(module_file.begin(), module_file.end());
    music_.reset(Mix_LoadMUSType_RW(reader_of(music_bytes_), MUS_MOD, 1));
    if (!music_) throw InputError("offset 0", std::string(Mix_GetError()) + ", expected a tracker module");
    set_music_volume(volume_256);
    Mix_PlayMusic(music_.get(), -1);
}

}  // namespace

std::unique_ptr<SoundOutput> open_mixer() {
    return std::make_unique<Mixer>();
}

}  // namespace oblong
