#include "engine/sound/mixer.h"

#include <algorithm>
#include <limits>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::int32_t kOne_16 = 1 << 16;
constexpr std::int32_t kGainStep_16 = kOne_16 / 882;     // from silence to full in 20 ms
constexpr std::int32_t kMuffled_16 = 5'600;              // 1 - exp(-2 pi 625 Hz / 44,100 Hz)
constexpr std::int32_t kCutoffStep_16 = kOne_16 / 2205;  // between muffled and not in 50 ms

std::int32_t towards(std::int32_t from, std::int32_t to, std::int32_t step) {
    return from < to ? std::min(from + step, to) : std::max(from - step, to);
}

std::int32_t cutoff_of(bool is_muffled) {
    return is_muffled ? kMuffled_16 : kOne_16;
}

std::int32_t low_passed(std::int32_t& state_8, std::int32_t input_8, std::int32_t cutoff_16) {
    state_8 += static_cast<std::int32_t>(std::int64_t{input_8 - state_8} * cutoff_16 / kOne_16);
    return state_8;
}

constexpr std::size_t kBlockFrames = 256;

std::int16_t saturated(std::int32_t sum) {
    using Limits = std::numeric_limits<std::int16_t>;
    return static_cast<std::int16_t>(std::clamp<std::int32_t>(sum, Limits::min(), Limits::max()));
}

}  // namespace

void VoiceFilter::begin(const VoiceLevels& levels, bool fades_in) {
    set(levels);
    cutoff_16_ = cutoff_of(levels.is_muffled);
    for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i] = Side{fades_in ? 0 : wanted_256_[i] * 256};
}

void VoiceFilter::set(const VoiceLevels& levels) {
    wanted_256_[0] = std::clamp(levels.left_256, 0, 256);
    wanted_256_[1] = std::clamp(levels.right_256, 0, 256);
    is_muffled_ = levels.is_muffled;
}

std::int16_t VoiceFilter::filtered(Side& side, std::int16_t sample, std::int32_t cutoff_16) const {
    const std::int32_t once = low_passed(side.first_8, sample * 256, cutoff_16);
    const std::int32_t twice = low_passed(side.second_8, once, cutoff_16);
    return static_cast<std::int16_t>(std::int64_t{twice} * side.gain_16 / (std::int64_t{256} * kOne_16));
}

void VoiceFilter::apply(std::span<std::int16_t> samples) {
    const std::array<std::int32_t, kSides> wanted_16{wanted_256_[0] * 256, wanted_256_[1] * 256};
    const std::int32_t wanted_cutoff = cutoff_of(is_muffled_);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t side = i % kSides;
        if (side == 0) cutoff_16_ = towards(cutoff_16_, wanted_cutoff, kCutoffStep_16);
        sides_[side].gain_16 = towards(sides_[side].gain_16, wanted_16[side], kGainStep_16);
        samples[i] = filtered(sides_[side], samples[i], cutoff_16_);
    }
}

SoundOutput::SoundNumber Mixer::add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) {
    const std::lock_guard lock(mutex_);
    recordings_.push_back({{samples.begin(), samples.end()}, rate_hz});
    return static_cast<SoundNumber>(recordings_.size()) - 1;
}

SoundOutput::VoiceNumber Mixer::start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) {
    const std::lock_guard lock(mutex_);
    MixerVoice* const voice = find(kNoVoice);
    if (voice == nullptr || recordings_.at(as_size(sound)).samples.empty()) return kNoVoice;
    *voice = {next_voice_++, as_size(sound), is_loop, false, false, 0, {}};
    voice->filter.begin(levels, is_loop);
    return voice->number;
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
void Mixer::add_voice(MixerVoice& voice, std::span<std::int32_t> sums) const {
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
        for (MixerVoice& voice : voices_)
            if (voice.number != kNoVoice && !voice.is_held) add_voice(voice, used);
        for (std::size_t i = 0; i < block.size(); ++i) block[i] = saturated(used[i]);
        samples = samples.subspan(block.size());
    }
}

}  // namespace oblong
