#include "game/sound/sound_player.h"

#include <filesystem>

#include "engine/base/table.h"
#include "engine/files/files.h"
#include "engine/files/sound_file.h"

namespace oblong {
namespace {

VoiceLevels at_volume(VoiceLevels levels, std::int32_t volume_256) {
    levels.left_256 = levels.left_256 * volume_256 / 256;
    levels.right_256 = levels.right_256 * volume_256 / 256;
    return levels;
}

std::string file_in(const std::vector<std::string>& folders, const std::string& name) {
    std::error_code ignored;
    for (const std::string& folder : folders) {
        const std::filesystem::path file = std::filesystem::path(folder) / name;
        if (std::filesystem::exists(file, ignored) || &folder == &folders.back()) return file.string();
    }
    return name;
}

}  // namespace

SoundPlayer::SoundPlayer(SoundOutput& output, const std::vector<std::string>& folders) : output_(output) {
    for (std::size_t i = 0; i < kSoundCount; ++i) {
        const Sound which = static_cast<Sound>(i);
        for (std::int32_t variant = 0; variant < row_of(which).variants; ++variant) {
            const std::string path = file_in(folders, file_of(which, variant));
            const SoundSamples sound = read_parsed(path, decode_flac);
            const auto number = output.add_sound(sound.samples, sound.rate_hz);
            if (variant == 0) first_numbers_.push_back(number);
        }
    }
}

void SoundPlayer::take_own(const LevelSounds& own) {
    own_numbers_.clear();
    for (const LevelSound& sound : own.sounds) {
        const auto [number, is_new] = number_of_file_.try_emplace(sound.file);
        if (is_new) number->second = output_.add_sound(sound.samples.samples, sound.samples.rate_hz);
        own_numbers_.push_back(number->second);
    }
}

SoundOutput::SoundNumber SoundPlayer::number_of(const AudibleSound& sound) const {
    if (sound.own != LevelSounds::kNone) return item(own_numbers_, sound.own);
    return item(first_numbers_, sound.sound) + sound.variant;
}

void SoundPlayer::play(std::span<const AudibleSound> sounds, std::int32_t volume_256) {
    std::map<Key, Voice> heard;
    for (const AudibleSound& sound : sounds) {
        const VoiceLevels levels = at_volume(sound.levels, volume_256);
        if (levels.left_256 + levels.right_256 == 0) continue;
        const Key key{sound.sound, sound.serial};
        const auto voice = voices_.find(key);
        if (voice == voices_.end()) {
            heard[key] = {output_.start(number_of(sound), row_of(sound.sound).is_loop(), levels), levels};
            continue;
        }
        if (voice->second.levels != levels) output_.adjust(voice->second.number, levels);
        heard[key] = {voice->second.number, levels};
        voices_.erase(voice);
    }
    stop_all();
    voices_ = std::move(heard);
}

void SoundPlayer::play_once(Sound sound, std::int32_t volume_256) {
    const std::int32_t level = row_of(sound).gain_256 * volume_256 / 256;
    if (level > 0) output_.start(item(first_numbers_, sound), false, {level, level, false});
}

void SoundPlayer::stop_all() {
    for (const auto& [key, voice] : voices_) output_.stop(voice.number);
    voices_.clear();
}

}  // namespace oblong
