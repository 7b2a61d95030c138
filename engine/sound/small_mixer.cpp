#include "engine/sound/small_mixer.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::int32_t kLevelStep_256 = 64;  // a block: from silence to full in 23 ms

}  // namespace

void SmallVoice::set(const VoiceLevels& levels) {
    wanted_256 = std::clamp((levels.left_256 + levels.right_256) / 2, 0, 256);
    is_muffled = levels.is_muffled;
}

std::vector<std::int8_t> SmallMixer::at_own_rate(std::span<const std::int16_t> samples, std::int32_t rate_hz) {
    const auto place = [rate_hz](std::size_t i) {
        if (rate_hz == kRate_hz) return i;  // under DOS, where 64-bit divisions are slow
        return static_cast<std::size_t>(std::uint64_t{i} * static_cast<std::uint64_t>(rate_hz) / kRate_hz);
    };
    std::vector<std::int8_t> result;
    const auto rate = static_cast<std::uint64_t>(rate_hz);
    result.reserve(static_cast<std::size_t>((samples.size() * std::uint64_t{kRate_hz} + rate - 1) / rate));
    for (std::size_t i = 0; place(i) < samples.size(); ++i) {
        const std::size_t from = place(i), to = std::clamp(place(i + 1), from + 1, samples.size());
        std::int32_t sum = 0;
        for (std::size_t at = from; at < to; ++at) sum += samples[at];
        const std::int32_t mean = sum / static_cast<std::int32_t>(to - from);
        result.push_back(static_cast<std::int8_t>(std::min((mean + 128) >> 8, 127)));
    }
    return result;
}

SoundOutput::SoundNumber SmallMixer::add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) {
    std::vector<std::int8_t> recording = at_own_rate(samples, rate_hz);
    const std::lock_guard lock(mutex_);
    recordings_.push_back(std::move(recording));
    return static_cast<SoundNumber>(recordings_.size()) - 1;
}

SoundOutput::VoiceNumber SmallMixer::start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) {
    const std::lock_guard lock(mutex_);
    SmallVoice* const voice = find(kNoVoice);
    if (voice == nullptr || recordings_.at(as_size(sound)).empty()) return kNoVoice;
    *voice = {};
    voice->number = next_voice_++;
    voice->recording = as_size(sound);
    voice->is_loop = is_loop;
    voice->set(levels);
    voice->level_256 = is_loop ? 0 : voice->wanted_256;
    return voice->number;
}

void SmallMixer::add_voice(SmallVoice& voice, std::span<std::int32_t> sums) const {
    const std::vector<std::int8_t>& recording = recordings_[voice.recording];
    voice.level_256 += std::clamp(voice.wanted_256 - voice.level_256, -kLevelStep_256, kLevelStep_256);
    bool has_ended = false;
    while (!sums.empty() && !has_ended) {
        const std::size_t count = std::min(sums.size(), recording.size() - voice.at);
        const std::int8_t* from = recording.data() + voice.at;
        const std::int32_t level = voice.level_256;
        if (voice.is_muffled)  // 1 - exp(-2 pi 505 Hz / 11,025 Hz) is a quarter
            for (std::size_t i = 0; i < count; ++i) {
                voice.passed_8 += (from[i] * 256 - voice.passed_8) >> 2;
                sums[i] += (voice.passed_8 >> 8) * level;
            }
        else
            for (std::size_t i = 0; i < count; ++i) sums[i] += from[i] * level;
        sums = sums.subspan(count);
        voice.at += count;
        if (voice.at < recording.size()) break;
        voice.at = 0;
        has_ended = !voice.is_loop;
    }
    if (has_ended || (voice.is_stopping && voice.level_256 == 0)) voice.number = kNoVoice;
}

bool SmallMixer::mix(std::span<std::uint8_t> samples) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock()) return false;
    while (!samples.empty()) {
        Sums sums{};
        const auto block = samples.first(std::min(samples.size(), sums.size()));
        const std::span<std::int32_t> used(sums.data(), block.size());
        for (SmallVoice& voice : voices_)
            if (voice.number != kNoVoice && !voice.is_held) add_voice(voice, used);
        for (std::size_t i = 0; i < block.size(); ++i)
            block[i] = static_cast<std::uint8_t>(std::clamp((used[i] >> 8) + kSilence, 0, 255));
        samples = samples.subspan(block.size());
    }
    return true;
}

}  // namespace oblong
