#include "engine/platform/mixer.h"

#include <algorithm>
#include <limits>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::size_t kBlockFrames = 256;

std::int16_t saturated(std::int32_t sum) {
    using Limits = std::numeric_limits<std::int16_t>;
    return static_cast<std::int16_t>(std::clamp<std::int32_t>(sum, Limits::min(), Limits::max()));
}

}  // namespace

SoundOutput::SoundNumber Mixer::add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) {
    const std::lock_guard lock(mutex_);
    recordings_.push_back({{samples.begin(), samples.end()}, rate_hz});
    return static_cast<SoundNumber>(recordings_.size()) - 1;
}

Mixer::Voice* Mixer::find(VoiceNumber number) {
    const auto voice = std::find_if(voices_.begin(), voices_.end(), [=](const Voice& v) { return v.number == number; });
    return voice == voices_.end() ? nullptr : &*voice;
}

SoundOutput::VoiceNumber Mixer::start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) {
    const std::lock_guard lock(mutex_);
    Voice* const voice = find(kNoVoice);
    if (voice == nullptr || recordings_.at(as_size(sound)).samples.empty()) return kNoVoice;
    *voice = {next_voice_++, as_size(sound), is_loop, false, false, 0, {}};
    voice->filter.begin(levels, is_loop);
    return voice->number;
}

bool Mixer::is_playing(VoiceNumber voice) const {
    const std::lock_guard lock(mutex_);
    return voice != kNoVoice &&
           std::any_of(voices_.begin(), voices_.end(), [=](const Voice& v) { return v.number == voice; });
}

void Mixer::adjust(VoiceNumber number, const VoiceLevels& levels) {
    const std::lock_guard lock(mutex_);
    Voice* const voice = number == kNoVoice ? nullptr : find(number);
    if (voice != nullptr && !voice->is_stopping) voice->filter.set(levels);
}

void Mixer::stop(VoiceNumber number) {
    const std::lock_guard lock(mutex_);
    Voice* const voice = number == kNoVoice ? nullptr : find(number);
    if (voice == nullptr) return;
    voice->is_stopping = true;
    voice->filter.set({});
}

void Mixer::hold_voices(bool are_held) {
    const std::lock_guard lock(mutex_);
    for (Voice& voice : voices_) voice.is_held = are_held;
}

void Mixer::play_music(std::span<const std::uint8_t> module_file, std::int32_t volume_256) {
    auto music = std::make_unique<ModulePlayer>(parse_module(module_file));
    const std::lock_guard lock(mutex_);
    music_ = std::move(music);
    music_volume_256_ = volume_256;
}

void Mixer::set_music_volume(std::int32_t volume_256) {
    const std::lock_guard lock(mutex_);
    music_volume_256_ = volume_256;
}

void Mixer::stop_music() {
    const std::lock_guard lock(mutex_);
    music_.reset();
}

// Interpolates linearly between the samples of a recording.
void Mixer::add_voice(Voice& voice, std::span<std::int32_t> sums) const {
    const Recording& recording = recordings_[voice.recording];
    const std::uint64_t length_32 = std::uint64_t{recording.samples.size()} << 32;
    const std::uint64_t step_32 = (static_cast<std::uint64_t>(recording.rate_hz) << 32) / kRate_hz;
    std::array<std::int16_t, 2 * kBlockFrames> own;
    const std::span<std::int16_t> wave(own.data(), sums.size());
    bool has_ended = false;
    for (std::size_t i = 0; i < wave.size(); i += 2) {
        wave[i] = wave[i + 1] = 0;
        if (has_ended) continue;
        const auto at = static_cast<std::size_t>(voice.at_32 >> 32);
        const auto share_16 = static_cast<std::int64_t>(voice.at_32 >> 16 & 0xffff);
        const bool is_last = at + 1 == recording.samples.size();
        const std::int32_t here = recording.samples[at];
        const std::int32_t there = !is_last ? recording.samples[at + 1] : voice.is_loop ? recording.samples[0] : 0;
        wave[i] = wave[i + 1] = static_cast<std::int16_t>(here + ((there - here) * share_16 >> 16));
        voice.at_32 += step_32;
        has_ended = !voice.is_loop && voice.at_32 >= length_32;
        if (voice.is_loop) voice.at_32 %= length_32;
    }
    voice.filter.apply(wave);
    for (std::size_t i = 0; i < wave.size(); ++i) sums[i] += wave[i];
    if (has_ended || (voice.is_stopping && voice.filter.is_silent())) voice.number = kNoVoice;
}

void Mixer::mix(std::span<std::int16_t> samples) {
    const std::lock_guard lock(mutex_);
    while (!samples.empty()) {
        std::array<std::int32_t, 2 * kBlockFrames> sums{};
        const auto block = samples.first(std::min(samples.size(), sums.size()));
        const std::span<std::int32_t> used(sums.data(), block.size());
        if (music_) music_->add(used, music_volume_256_);
        for (Voice& voice : voices_)
            if (voice.number != kNoVoice && !voice.is_held) add_voice(voice, used);
        for (std::size_t i = 0; i < block.size(); ++i) block[i] = saturated(used[i]);
        samples = samples.subspan(block.size());
    }
}

}  // namespace oblong
