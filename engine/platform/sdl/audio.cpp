#include <SDL.h>

#include <stdexcept>
#include <string>

#include "engine/platform/sdl/sdl.h"
#include "engine/sound/mixer.h"

namespace oblong {
namespace {

constexpr Uint16 kBuffer_frames = 1024;

[[noreturn]] void fail() {
    throw std::runtime_error(std::string("no sound: ") + SDL_GetError());
}

using AlsaErrorHandler = void (*)(const char* file, int line, const char* function, int error, const char* format, ...);

void ignore_alsa_error(const char*, int, const char*, int, const char*, ...) {}

// Without a sound card, ALSA's library writes a dozen lines to standard error; the game's own message is one line.
void silence_alsa() {
    void* library = SDL_LoadObject("libasound.so.2");
    if (library == nullptr) return;
    using SetHandler = int (*)(AlsaErrorHandler);
    const auto set_handler = reinterpret_cast<SetHandler>(SDL_LoadFunction(library, "snd_lib_error_set_handler"));
    if (set_handler != nullptr) set_handler(ignore_alsa_error);
}

// SDL requests samples in its own thread, and converts them for the device if needed.
class SdlAudio final : public Mixer {
  public:
    SdlAudio() {
        silence_alsa();
        if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) fail();
        SDL_AudioSpec wanted{};
        wanted.freq = kRate_hz;
        wanted.format = AUDIO_S16SYS;
        wanted.channels = 2;
        wanted.samples = kBuffer_frames;
        wanted.userdata = this;
        wanted.callback = [](void* mixer, Uint8* stream, int bytes) {
            const auto count = static_cast<std::size_t>(bytes) / sizeof(std::int16_t);
            static_cast<SdlAudio*>(mixer)->mix({reinterpret_cast<std::int16_t*>(stream), count});
        };
        device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
        if (device_ == 0) {
            SDL_QuitSubSystem(SDL_INIT_AUDIO);
            fail();
        }
        SDL_PauseAudioDevice(device_, 0);
    }
    ~SdlAudio() override {
        SDL_CloseAudioDevice(device_);
        SDL_QuitSubSystem(SDL_INIT_AUDIO);
    }
    SdlAudio(const SdlAudio&) = delete;
    SdlAudio& operator=(const SdlAudio&) = delete;

  private:
    SDL_AudioDeviceID device_ = 0;
};

}  // namespace

std::unique_ptr<SoundOutput> open_mixer() {
    return std::make_unique<SdlAudio>();
}

}  // namespace oblong
