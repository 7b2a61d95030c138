#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/effects/fog.h"
#include "engine/scene/level_effects.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// The fog of a level in a palette's colours; each row is made when a frame first shows it.
class LevelFogTables {
  public:
    LevelFogTables(const LevelFog& fog, const Palette& palette);
    const FogDepths& depths() const { return depths_; }
    const ColourRow& colours(std::int32_t level);
    /// The table, with the rows for these runs made.
    const FogTable& colours_of(std::span<const FogRun> runs);

  private:
    Palette palette_;
    Rgb8 colour_;
    std::int32_t share_256_;
    FogDepths depths_;
    FogTable colours_;
    std::array<bool, FogTable::kLevels> is_made_{};
};

/// The fog of a frame.
struct FrameFog {
    LevelFogTables* tables = nullptr;     ///< null: none
    std::optional<HeightFogView> height;  ///< for height fog
    World top = World::highest();         ///< if eye and face are both above it, the face is clear
};

}  // namespace oblong
