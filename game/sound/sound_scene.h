#pragma once

#include <cstdint>
#include <vector>

#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/sound/audible.h"
#include "game/sound/sound_starts.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// The permanent sounds of a level: liquids, teleporters, wind under the sky, lamps, rain, sparks, bubbles, flames, and
/// Quake's ambient_ entities. Found once, when it is made.
class Ambience {
  public:
    explicit Ambience(const Level& level);

    /// Appends the sources within range of a point.
    void collect(const Position& ear, std::vector<SoundSource>& sources) const;
    const std::vector<SoundSource>& all() const { return sources_; }

  private:
    std::vector<SoundSource> sources_;
    BoxTree heard_in_;  ///< by the indices of sources
};

class SoundScene {
  public:
    /// The level outlives it, and so do its own sounds.
    explicit SoundScene(const GameLevel& level, const LevelSounds* own = nullptr);

    /// Finds what the player of `after` hears after a tick.
    void note_tick(const GameState& before, const GameState& after, const TickReport& report);
    const Audible& audible() const { return audible_; }

  private:
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
    std::vector<OneShot> one_shots_;  // not ended, and heard in each tick so far
    Audible audible_;
};

}  // namespace oblong
