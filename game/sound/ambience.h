#pragma once

#include <vector>

#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/sound/sound_source.h"

namespace oblong {

/// What sounds in a level all the time: liquids, teleporters, the wind under the sky, lamps, rain, sparks, bubbles,
/// flames, and Quake's ambient_ entities. Found once.
class Ambience {
  public:
    explicit Ambience(const Level& level);

    /// Appends those that may be heard from a point.
    void collect(const Position& ear, std::vector<SoundSource>& sources) const;
    const std::vector<SoundSource>& all() const { return sources_; }

  private:
    std::vector<SoundSource> sources_;
    BoxTree heard_in_;  ///< by the indices of sources
};

}  // namespace oblong
