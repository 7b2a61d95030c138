#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/sound/sound.h"
#include "game/sound/audible.h"
#include "game/sound/captions.h"
#include "game/sound/sound_scene.h"

namespace oblong {

/// Plays the sounds that are heard: starts, adjusts and stops voices by the differences from tick to tick.
class SoundPlayer {
  public:
    /// The output outlives it. Reads the files of all sounds, each from the first of the folders that has it. Throws
    /// FileError.
    SoundPlayer(SoundOutput& output, const std::vector<std::string>& folders);

    /// Sets the sounds that AudibleSound::own is an index of. Each file is given to the output once.
    void take_own(const LevelSounds& own);

    /// Makes the voices those of `sounds`, `volume_256` from 0 to 256. One-shots are started once.
    void play(std::span<const AudibleSound> sounds, std::int32_t volume_256);
    /// Plays a sound of a menu.
    void play_once(Sound sound, std::int32_t volume_256);
    void stop_all();

  private:
    struct Key {
        Sound sound;
        std::uint32_t serial;
        auto operator<=>(const Key&) const = default;
    };
    struct Voice {
        SoundOutput::VoiceNumber number;
        VoiceLevels levels;
    };
    SoundOutput::SoundNumber number_of(const AudibleSound& sound) const;

    SoundOutput& output_;
    std::vector<SoundOutput::SoundNumber> first_numbers_;  // by sound, of the first variant
    std::vector<SoundOutput::SoundNumber> own_numbers_;
    std::map<std::string, SoundOutput::SoundNumber> number_of_file_;  // of all own sounds so far
    std::map<Key, Voice> voices_;
};

/// The player's settings of sound.
struct SoundSettings {
    std::int32_t volume_100 = 0;  ///< of all, 0 to 100; 0: no device is opened
    std::int32_t sounds_100 = 100, music_100 = 100;
    bool shows_captions = false;

    bool operator==(const SoundSettings&) const = default;
};

/// A game's own sounds and captions.
struct OwnSounds {
    std::string folder;     ///< its folder `sounds` replaces files of the museum's; empty: none
    CaptionTexts captions;  ///< other texts for some sounds
    std::map<std::string, std::string> level_captions;  ///< for levels' own sounds, by LevelSound::name
};

/// The game's sound. Opens a device when a volume is above 0, and finds out what is heard only if it is played or shown
/// as captions.
class GameSound {
  public:
    /// `open` may be empty: no sound. `assets_folder`: the museum's, with a folder `sounds`.
    GameSound(OpenSound open, std::string assets_folder, OwnSounds own = {});

    /// If the device cannot be opened or a file is missing, reports it once on standard error, and stays silent.
    void set(const SoundSettings& settings);

    /// Sets the level that is heard; null: none. The level and `own` must outlive this object, or the next call.
    void enter(const GameLevel* level, const LevelSounds* own = nullptr);
    /// `is_last`: SoundScene::note_tick()'s.
    void note_tick(const GameState& before, const GameState& after, const TickReport& report, bool is_last = true);
    /// A pause or a menu over the game: sounds are paused, music is softer.
    void hold(bool is_held);

    /// A sound of a menu: MenuMove, MenuAccept, MenuBack.
    void play(Sound sound);
    /// Plays a file's music; an empty name: none.
    void play_music(const std::string& file);

    /// The captions; empty unless they are shown.
    std::vector<std::string> captions() const { return captions_ ? captions_->lines() : std::vector<std::string>(); }

  private:
    bool has_sounds() const { return player_ != nullptr && settings_.sounds_100 > 0; }
    void open_device();
    void keep_what_is_on();
    std::vector<std::string> level_captions() const;
    void start_music();
    std::int32_t sounds_256() const;
    std::int32_t music_256() const;

    OpenSound open_;  // empty once it has failed
    std::string assets_folder_;
    OwnSounds own_;
    std::string music_file_;  // to be played; empty: none
    SoundSettings settings_;
    std::unique_ptr<SoundOutput> output_;  // only while a volume is above 0
    std::unique_ptr<SoundPlayer> player_;  // likewise; must not outlive the output
    const GameLevel* level_ = nullptr;
    const LevelSounds* level_sounds_ = nullptr;  // the level's own
    std::unique_ptr<SoundScene> scene_;          // only while sounds or captions are on
    std::unique_ptr<Captions> captions_;         // only while they are shown
    bool is_held_ = false, plays_music_ = false;
};

}  // namespace oblong
