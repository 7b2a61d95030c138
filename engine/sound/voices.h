#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>

#include "engine/sound/sound.h"

namespace oblong {

/// The voices of a mixer, guarded as another thread mixes them. A Voice has a `number` (kNoVoice: unused), `is_held`,
/// `is_stopping`, and functions set() and fade_out(), which begin to change its levels.
template <class Voice, std::int32_t kCount>
class MixerOfVoices : public SoundOutput {
  public:
    static constexpr std::int32_t kVoices = kCount;

    bool is_playing(VoiceNumber number) const override {
        const std::lock_guard lock(mutex_);
        return number != kNoVoice &&
               std::any_of(voices_.begin(), voices_.end(), [=](const Voice& voice) { return voice.number == number; });
    }
    void adjust(VoiceNumber number, const VoiceLevels& levels) override {
        const std::lock_guard lock(mutex_);
        Voice* const voice = number == kNoVoice ? nullptr : find(number);
        if (voice != nullptr && !voice->is_stopping) voice->set(levels);
    }
    void stop(VoiceNumber number) override {
        const std::lock_guard lock(mutex_);
        Voice* const voice = number == kNoVoice ? nullptr : find(number);
        if (voice == nullptr) return;
        voice->is_stopping = true;
        voice->fade_out();
    }
    void hold_voices(bool are_held) override {
        const std::lock_guard lock(mutex_);
        for (Voice& voice : voices_) voice.is_held = are_held;
    }

  protected:
    Voice* find(VoiceNumber number) {
        const auto is_it = [=](const Voice& voice) { return voice.number == number; };
        const auto voice = std::find_if(voices_.begin(), voices_.end(), is_it);
        return voice == voices_.end() ? nullptr : &*voice;
    }

    mutable std::mutex mutex_;
    std::array<Voice, kVoices> voices_;
    VoiceNumber next_voice_ = 0;
};

}  // namespace oblong
