#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/simulation/game_level.h"
#include "game/simulation/tick.h"
#include "game/sound/audible.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// The sound of a step on a texture, by words in its name; stone if no word is known.
Sound step_sound_of_texture(std::string_view name);

/// The sounds of a moving brush model.
struct MoverSounds {
    Sound start, move, stop;
};

/// By the class of the mover's entity, and the texture of its first face.
MoverSounds mover_sounds(const Level& bsp, ModelIndex model);

/// The sounds that begin in a tick, found from the states before and after it and the triggers that have fired.
class SoundStarts {
  public:
    /// The most sounds that movers begin in a tick, as each is compared with the others; further ones are silent.
    static constexpr std::size_t kMost = 64;

    /// The level outlives it, and so do its own sounds.
    explicit SoundStarts(const GameLevel& level, const LevelSounds* own = nullptr);

    /// Appends the sounds that begin in a tick, and loops for what moves in it.
    void note_tick(const GameState& before, const GameState& after, const TickReport& report,
                   std::vector<SoundSource>& sources);

  private:
    void note_player(const GameState& before, const GameState& after, const TickReport& report,
                     std::vector<SoundSource>& sources);
    void note_way(const GameState& before, const GameState& after, std::vector<SoundSource>& sources);
    void note_movers(const GameState& before, const GameState& after, std::vector<SoundSource>& sources);
    void note_messages(const GameState& before, const GameState& after, const TickReport& report,
                       std::vector<SoundSource>& sources);
    std::int32_t own_of_trigger(const Trigger& trigger, const GameState& state) const;
    bool is_own_teleporter(std::uint32_t trigger) const;
    std::int32_t own_of(std::size_t entity) const { return own_ ? item(own_->by_entity, entity) : LevelSounds::kNone; }
    void add(Sound sound, std::int32_t own, std::vector<SoundSource>& sources);
    void add_at(Sound sound, std::uint32_t mover, const GameState& after, std::vector<SoundSource>& sources);

    const GameLevel& level_;
    const LevelSounds* own_;                  // null: none
    std::vector<MoverSounds> mover_sounds_;   // in the order of the level's movers
    std::vector<std::uint32_t> were_moving_;  // movers, ascending, in the last tick
    World since_step_;                        // the distance walked or swum since the last step or stroke
    World fall_speed_;                        // the largest since the player last stood, downward negative
    std::uint32_t last_serial_ = 0;
};

/// The permanent sounds of a level: liquids, teleporters, wind under the sky, lamps, rain, sparks, bubbles, flames, and
/// Quake's ambient_ entities. Found once, when it is made.
class Ambience {
  public:
    explicit Ambience(const Level& level);

    /// Appends the sources within range of a point.
    void collect(const Position& ear, std::vector<SoundSource>& sources) const;

  private:
    std::vector<SoundSource> sources_;
    BoxTree heard_in_;  ///< by the indices of sources
};

class SoundScene {
  public:
    /// The level outlives it, and so do its own sounds.
    explicit SoundScene(const GameLevel& level, const LevelSounds* own = nullptr);

    /// Finds what the player of `after` hears after a tick. Not of one that others follow at once (`is_last`), as where
    /// a picture takes longer than a tick: hearing is more work than the tick.
    void note_tick(const GameState& before, const GameState& after, const TickReport& report, bool is_last = true);
    const Audible& audible() const { return audible_; }

  private:
    void hear(const GameState& state, std::vector<SoundSource> sources);
    void keep_heard();
    std::int32_t length_ticks(const SoundSource& source) const;

    struct OneShot {
        SoundSource source;
        std::int32_t ticks_left;
    };
    const GameLevel& level_;
    const LevelSounds* own_;
    Ambience ambience_;
    SoundStarts starts_;
    HeardFrom heard_from_;
    std::vector<OneShot> one_shots_;  // not ended, and heard whenever the player listened
    Audible audible_;
};

}  // namespace oblong
