#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/platform/sound.h"
#include "game/sound/captions.h"
#include "game/sound/sound_player.h"
#include "game/sound/sound_scene.h"

namespace oblong {

/// What the player sets of sound.
struct SoundSettings {
    std::int32_t volume_100 = 0;  ///< of all, 0 to 100; 0: no device is opened
    std::int32_t sounds_100 = 100, music_100 = 100;
    bool shows_captions = false;

    bool operator==(const SoundSettings&) const = default;
};

/// What a game has of its own.
struct OwnSounds {
    std::string folder;     ///< with a folder sounds, whose files are played instead of the museum's; empty: none
    CaptionTexts captions;  ///< other words for some sounds
    std::map<std::string, std::string> level_captions;  ///< for levels' own, by LevelSound::name
};

/// The game's sound: opens a device when there is something to hear, and works out what is heard only where it is heard
/// or written as captions.
class GameSound {
  public:
    /// `open` may be empty: all is silent. `assets_folder`: the museum's, with a folder sounds.
    GameSound(OpenSound open, std::string assets_folder, OwnSounds own = {});
    ~GameSound();

    /// Where the device cannot be opened or a file is missing: says so once, on standard error, and stays silent.
    void set(const SoundSettings& settings);

    /// The level that is heard from now on, in silence at first; it and its own sounds outlive this or are left before.
    /// Null: none.
    void enter(const GameLevel* level, const LevelSounds* own = nullptr);
    void note_tick(const GameState& before, const GameState& after, const TickReport& report);
    /// A pause or a menu over the game: sounds stay where they are, music is softer.
    void hold(bool is_held);

    /// A sound of a menu: MenuMove, MenuAccept, MenuBack.
    void play(Sound sound);
    /// Plays a file's music from now on; an empty name: none.
    void play_music(const std::string& file);

    /// What is heard, in words; empty unless captions are shown.
    std::vector<std::string> captions() const;

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
    std::string music_file_;  // that is to be heard; empty: none
    SoundSettings settings_;
    std::unique_ptr<SoundOutput> output_;  // only while a volume is above 0
    std::unique_ptr<SoundPlayer> player_;  // likewise; does not outlive the output
    const GameLevel* level_ = nullptr;
    const LevelSounds* level_sounds_ = nullptr;  // the level's own
    std::unique_ptr<SoundScene> scene_;          // only while it is heard or written
    std::unique_ptr<Captions> captions_;         // only while they are shown
    bool is_held_ = false, plays_music_ = false;
};

}  // namespace oblong
