#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/sound/sound.h"
#include "game/simulation/game_level.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// The player as a listener.
struct Listener {
    Position ear;
    Angle yaw;  ///< of the view
    bool is_under_water = false;
};
Listener listener_of(const Player& player);

/// The direction of a sound relative to the listener's view.
enum class Direction : std::uint8_t { Here, Ahead, Left, Right, Behind };

/// A sound that is heard now.
struct AudibleSound {
    Sound sound = Sound::Wind;
    std::int32_t variant = 0;
    std::uint32_t serial = 0;  ///< of its source; 0: a loop, one for each sound
    VoiceLevels levels;
    Direction direction = Direction::Here;
    std::int32_t own = LevelSounds::kNone;  ///< SoundSource::own
};

/// The audible sounds, and the work of finding them.
struct Audible {
    std::vector<AudibleSound> sounds;  ///< at most kMostAudible, the loudest ones
    std::int32_t traces = 0;           ///< lines through the level: none for sources out of range
};
inline constexpr std::size_t kMostAudible = 24, kMostSourcesOfALoop = 3;
inline constexpr std::size_t kMostLinesOfASource = 5;  ///< for a hidden area; one if the first is clear

/// The volume of a source on each side: (1 - distance / range)^2 of its gain, panned with constant power; 0 beyond its
/// range. Without muffling.
VoiceLevels levels_at(const SoundSource& source, const Listener& listener);

/// Whether nothing solid is between two points: neither the world nor a brush model at its current place, other than
/// `except` and fences, through whose holes sound passes.
bool is_clear(const GameLevel& level, const GameState& state, const Position& from, const Position& to,
              ModelIndex except);

/// Remembers from which of its places each loop was heard, so that lines are traced for it only every fourth time:
/// tracing is most of the work of hearing.
class HeardFrom {
  public:
    static constexpr std::uint32_t kTimes = 4;

    /// Forgets what is kTimes old.
    void start();
    std::optional<std::size_t> place_of(const SoundSource& source) const;
    void note(const SoundSource& source, std::size_t place);

  private:
    struct Known {
        Sound sound;
        Box box;
        std::size_t place;
        std::uint32_t time;
    };
    std::vector<Known> known_;
    std::uint32_t time_ = 0;
};

/// The sounds of some sources that a listener hears. Loops of one sound are merged: each ear hears the loudest of them.
/// An area is heard from the nearest of its places with a clear line to the listener. A source without a clear line is
/// softer and muffled; under water, all are muffled. For loops in `heard_from`, no lines are traced.
Audible audible_sounds(const GameLevel& level, const GameState& state, const Listener& listener,
                       std::span<const SoundSource> sources, HeardFrom& heard_from);

}  // namespace oblong
