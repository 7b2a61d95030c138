#include "game/sound/game_sound.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "engine/sound/sound_file.h"

namespace oblong {
namespace {

std::string file_in(const std::vector<std::string>& folders, const std::string& name) {
    const std::string found = find_below(folders, name);
    return found.empty() ? (std::filesystem::path(folders.back()) / name).string() : found;
}

std::int32_t product_256(std::int32_t one_100, std::int32_t other_100) {
    return one_100 * other_100 * 256 / 10'000;
}

std::string in_folder(const std::string& folder, const char* name) {
    return (std::filesystem::path(folder) / name).string();
}

}  // namespace

SoundPlayer::SoundPlayer(SoundOutput& output, const std::vector<std::string>& folders) : output_(output) {
    for (std::size_t i = 0; i < kSoundCount; ++i) {
        const Sound which = static_cast<Sound>(i);
        if (row_of(which).variants == 0) first_numbers_.emplace_back();
        for (std::int32_t variant = 0; variant < row_of(which).variants; ++variant) {
            const std::string path = file_in(folders, file_of(which, variant));
            const SoundSamples sound = read_parsed(path, decode_sound);
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
        const VoiceLevels levels = sound.levels.times_256(volume_256);
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

GameSound::GameSound(OpenSound open, std::string assets_folder, OwnSounds own)
    : open_(std::move(open)), assets_folder_(std::move(assets_folder)), own_(std::move(own)) {}

std::int32_t GameSound::sounds_256() const {
    return product_256(settings_.volume_100, settings_.sounds_100);
}

std::int32_t GameSound::music_256() const {
    return product_256(settings_.volume_100, settings_.music_100) / (is_held_ ? 2 : 1);
}

void GameSound::set(const SoundSettings& settings) {
    if (settings == settings_) return;
    settings_ = settings;
    const bool needs_device = settings.volume_100 > 0 && settings.sounds_100 + settings.music_100 > 0;
    if (!needs_device) {
        player_.reset();
        output_.reset();
        plays_music_ = false;
    } else if (!output_ && open_) {
        open_device();
    }
    keep_what_is_on();
}

void GameSound::open_device() {
    try {
        output_ = open_();
        std::vector<std::string> folders{in_folder(assets_folder_, "sounds")};
        if (!own_.folder.empty()) folders.insert(folders.begin(), in_folder(own_.folder, "sounds"));
        player_ = std::make_unique<SoundPlayer>(*output_, folders);
        if (level_sounds_) player_->take_own(*level_sounds_);
    } catch (const std::exception& error) {
        print_fault("oblong", error.what());
        player_.reset();
        output_.reset();
        open_ = nullptr;
    }
}

// Creates what the settings need, and frees the rest.
void GameSound::keep_what_is_on() {
    if (!settings_.shows_captions)
        captions_.reset();
    else if (!captions_)
        captions_ = std::make_unique<Captions>(own_.captions, level_captions());
    if (level_ == nullptr || !(has_sounds() || captions_))
        scene_.reset();
    else if (!scene_)
        scene_ = std::make_unique<SoundScene>(*level_, level_sounds_);
    if (player_ && !(scene_ && has_sounds())) player_->stop_all();
    if (output_ && !music_file_.empty()) start_music();
}

std::vector<std::string> GameSound::level_captions() const {
    std::vector<std::string> texts;
    if (!level_sounds_) return texts;
    for (const LevelSound& sound : level_sounds_->sounds) {
        const auto own = own_.level_captions.find(sound.name);
        texts.push_back(own == own_.level_captions.end() ? "" : own->second);
    }
    return texts;
}

void GameSound::enter(const GameLevel* level, const LevelSounds* own) {
    if (player_) player_->stop_all();
    scene_.reset();
    captions_.reset();
    level_ = level;
    level_sounds_ = own;
    if (player_ && own) player_->take_own(*own);
    keep_what_is_on();
}

void GameSound::note_tick(const GameState& before, const GameState& after, const TickReport& report, bool is_last) {
    if (!scene_) return;
    scene_->note_tick(before, after, report, is_last);
    const std::span<const AudibleSound> sounds = scene_->audible().sounds;
    if (has_sounds() && is_last) player_->play(sounds, sounds_256());
    if (captions_) captions_->note_tick(sounds);
}

void GameSound::hold(bool is_held) {
    if (is_held == is_held_) return;
    is_held_ = is_held;
    if (!output_) return;
    output_->hold_voices(is_held);
    output_->set_music_volume(music_256());
}

void GameSound::play(Sound sound) {
    if (has_sounds()) player_->play_once(sound, sounds_256());
}

void GameSound::play_music(const std::string& file) {
    plays_music_ = false;
    music_file_ = file;
    if (!output_) return;
    if (file.empty()) return output_->stop_music();
    start_music();
}

// Starts the music, or sets its volume if it plays already.
void GameSound::start_music() {
    if (std::exchange(plays_music_, true)) return output_->set_music_volume(music_256());
    try {
        naming_file(music_file_, [&] { output_->play_music(read_file(music_file_), music_256()); });
    } catch (const FileError& error) {
        print_fault("oblong", error.what());
    }
}

}  // namespace oblong
