#pragma once

#include <vector>

#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/sound/sound_source.h"

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

}  // namespace oblong
