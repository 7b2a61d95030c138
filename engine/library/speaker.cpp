#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "engine/io/files.h"
#include "engine/library/conversions.h"
#include "engine/library/ogg.h"
#include "engine/platform/sdl/sdl.h"
#include "engine/sound/sound_file.h"
#include "engine/sound/tracker_module.h"

namespace oblong {
namespace {

VoiceLevels levels_of(std::int32_t volume_256, std::int32_t pan_256) {
    const std::int32_t volume = std::clamp(volume_256, 0, 256), pan = std::clamp(pan_256, -256, 256);
    return {volume * std::min(256 - pan, 256) / 256, volume * std::min(256 + pan, 256) / 256, false};
}

}  // namespace

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

Speaker::~Speaker() = default;
Speaker::Speaker(Speaker&& other) noexcept = default;
Speaker& Speaker::operator=(Speaker&& other) noexcept = default;

std::int32_t Speaker::load(const File& file) {
    const SoundSamples sound = read_parsed(file, [](std::span<const std::uint8_t> bytes) {
        return is_ogg(bytes) ? decode_ogg(bytes) : decode_sound(bytes);
    });
    return add(sound.samples, sound.rate_hz);
}

std::int32_t Speaker::add(const std::vector<std::int16_t>& samples, std::int32_t rate_hz) {
    if (samples.empty() || rate_hz < 1)
        throw argument_error("sound", std::to_string(samples.size()) + " samples at " + std::to_string(rate_hz) +
                                          " Hz, expected one or more of each");
    if (state_->output) state_->output->add_sound(samples, rate_hz);
    return state_->sounds++;
}

std::int64_t Speaker::play(std::int32_t sound, std::int32_t volume_256, std::int32_t pan_256, bool is_loop) {
    if (sound < 0 || sound >= state_->sounds)
        throw argument_error("sound",
                             "number " + std::to_string(sound) + ", expected one that load() or add() returned");
    if (!state_->output) return SoundOutput::kNoVoice;
    return state_->output->start(sound, is_loop, levels_of(volume_256, pan_256));
}

bool Speaker::is_playing(std::int64_t playing) const {
    return state_->output && state_->output->is_playing(playing);
}

void Speaker::set_volume(std::int64_t playing, std::int32_t volume_256, std::int32_t pan_256) {
    if (state_->output) state_->output->adjust(playing, levels_of(volume_256, pan_256));
}

void Speaker::stop(std::int64_t playing) {
    if (state_->output) state_->output->stop(playing);
}

void Speaker::play_music(const File& file, std::int32_t volume_256) {
    read_parsed(file, [&](std::span<const std::uint8_t> bytes) {
        if (state_->output)
            state_->output->play_music(bytes, std::clamp(volume_256, 0, 256));
        else
            parse_module(bytes);  // wrong files are found without a device, too
    });
}

void Speaker::set_music_volume(std::int32_t volume_256) {
    if (state_->output) state_->output->set_music_volume(std::clamp(volume_256, 0, 256));
}

void Speaker::stop_music() {
    if (state_->output) state_->output->stop_music();
}

const std::string& Speaker::problem() const {
    return state_->problem;
}

}  // namespace oblong
