#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "engine/io/files.h"
#include "engine/library/conversions.h"
#include "engine/platform/sdl/sdl.h"
#include "engine/sound/sound_file.h"
#include "engine/sound/tracker_module.h"

namespace oblong {

struct Speaker::State {
    std::unique_ptr<SoundOutput> output;  // null: silence
    std::string problem;
    std::int32_t sounds = 0;
};

Speaker::Speaker() : state_(new State) {
    if (std::getenv("OBLONG_HEADLESS")) {
        state_->problem = "OBLONG_HEADLESS: no sound";
        return;
    }
    try {
        state_->output = open_mixer();
    } catch (const std::runtime_error& error) {
        state_->problem = error.what();
    }
}

Speaker::~Speaker() {
    delete state_;
}

std::int32_t Speaker::load(const std::string& file) {
    const SoundSamples sound = read_parsed(file, decode_sound);
    return add(sound.samples, sound.rate_hz);
}

std::int32_t Speaker::add(const std::vector<std::int16_t>& samples, std::int32_t rate_hz) {
    if (samples.empty() || rate_hz < 1)
        throw argument_error("sound", std::to_string(samples.size()) + " samples at " + std::to_string(rate_hz) +
                                          " Hz, expected one or more of each");
    if (state_->output) state_->output->add_sound(samples, rate_hz);
    return state_->sounds++;
}

void Speaker::play(std::int32_t sound, std::int32_t volume_256, std::int32_t pan_256) {
    if (sound < 0 || sound >= state_->sounds)
        throw argument_error("sound",
                             "number " + std::to_string(sound) + ", expected one that load() or add() returned");
    if (!state_->output) return;
    const std::int32_t volume = std::clamp(volume_256, 0, 256), pan = std::clamp(pan_256, -256, 256);
    state_->output->start(sound, false,
                          {volume * std::min(256 - pan, 256) / 256, volume * std::min(256 + pan, 256) / 256, false});
}

void Speaker::play_music(const std::string& file, std::int32_t volume_256) {
    const std::vector<std::uint8_t> bytes = read_file(file);
    naming_file(file, [&] {
        if (state_->output)
            state_->output->play_music(bytes, std::clamp(volume_256, 0, 256));
        else
            parse_module(bytes);  // wrong files are found without a device, too
    });
}

void Speaker::stop_music() {
    if (state_->output) state_->output->stop_music();
}

const std::string& Speaker::problem() const {
    return state_->problem;
}

}  // namespace oblong
