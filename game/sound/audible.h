#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/platform/sound.h"
#include "game/simulation/game_level.h"
#include "game/sound/sound_source.h"

namespace oblong {

/// Who hears.
struct Listener {
    Position ear;
    Angle yaw;  ///< where they look
    bool is_under_water = false;
};
Listener listener_of(const Player& player);

/// From where a sound comes, as seen by the listener.
enum class Direction : std::uint8_t { Here, Ahead, Left, Right, Behind };

/// A sound that is heard now.
struct AudibleSound {
    Sound sound = Sound::Wind;
    std::int32_t variant = 0;
    std::uint32_t serial = 0;  ///< of its source; 0: a loop, of which there is one for each sound
    VoiceLevels levels;
    Direction direction = Direction::Here;
    std::int32_t own = LevelSounds::kNone;  ///< SoundSource::own
};

/// What is heard, and how much work it was to find out.
struct Audible {
    std::vector<AudibleSound> sounds;  ///< at most kMostAudible, the loudest ones
    std::int32_t traces = 0;           ///< lines through the level: none for sources out of range
};
inline constexpr std::size_t kMostAudible = 24, kMostSourcesOfALoop = 3;
inline constexpr std::size_t kMostLinesOfASource = 5;  ///< of an area that is all hidden; one to what is in sight

/// How loud a source sounds on each side: (1 - distance / range)^2 of its gain, turned to the sides with constant
/// power. Nothing is muffled yet. Zero from its range on.
VoiceLevels levels_at(const SoundSource& source, const Listener& listener);

/// Whether a straight line joins two points, through neither the world nor brush models where they are now but
/// `except`.
bool is_clear(const GameLevel& level, const GameState& state, const Position& from, const Position& to,
              ModelIndex except);

/// From which of its places each loop that stays where it is was heard. It is asked anew every fourth tick, as lines
/// through the level are most of the work of hearing.
class HeardFrom {
  public:
    static constexpr std::uint32_t kTicks = 4;

    /// Forgets what was asked so many ticks ago.
    void start_tick();
    std::optional<std::size_t> place_of(const SoundSource& source) const;
    void note(const SoundSource& source, std::size_t place);

  private:
    struct Known {
        Sound sound;
        Box box;
        std::size_t place;
        std::uint32_t tick;
    };
    std::vector<Known> known_;
    std::uint32_t tick_ = 0;
};

/// What a listener hears of some sources. Loops of one sound become one: each ear hears the loudest of them. An area is
/// heard from the nearest of its parts that a straight line reaches. What no line reaches is softer and muffled; under
/// water, all is muffled. Of loops that `heard_from` knows no lines are traced.
Audible audible_sounds(const GameLevel& level, const GameState& state, const Listener& listener,
                       std::span<const SoundSource> sources, HeardFrom& heard_from);

}  // namespace oblong
