#pragma once

#include <map>

#include "engine/platform/sound.h"

namespace oblong::test {

/// Plays nothing, and remembers what it was asked for.
class RecordedOutput final : public SoundOutput {
  public:
    struct Voice {
        SoundNumber sound;
        bool is_loop;
        VoiceLevels levels;
    };

    SoundNumber add_sound(std::span<const std::int16_t>, std::int32_t) override { return sounds++; }
    VoiceNumber start(SoundNumber sound, bool is_loop, const VoiceLevels& levels) override {
        voices[++starts] = {sound, is_loop, levels};
        return starts;
    }
    bool is_playing(VoiceNumber voice) const override { return voices.contains(voice); }
    void adjust(VoiceNumber voice, const VoiceLevels& levels) override {
        ++adjusts;
        voices.at(voice).levels = levels;
    }
    void stop(VoiceNumber voice) override { voices.erase(voice); }
    void hold_voices(bool now_held) override { are_held = now_held; }
    void play_music(std::span<const std::uint8_t> file, std::int32_t volume_256) override {
        music_size = file.size();
        music_volume_256 = volume_256;
    }
    void set_music_volume(std::int32_t volume_256) override { music_volume_256 = volume_256; }
    void stop_music() override { music_size = 0; }

    SoundNumber sounds = 0;
    VoiceNumber starts = 0;
    int adjusts = 0;
    std::map<VoiceNumber, Voice> voices;
    bool are_held = false;
    std::size_t music_size = 0;
    std::int32_t music_volume_256 = 0;
};

}  // namespace oblong::test
