#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/effects/fog.h"
#include "engine/effects/height_fog.h"
#include "engine/frame/claims.h"
#include "engine/scene/level_effects.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// The fog of a level in the colours of a palette, each level of it made when a frame first shows it.
class LevelFogTables {
  public:
    LevelFogTables(const LevelFog& fog, const Palette& palette);
    const FogDepths& depths() const { return depths_; }
    const ColourRow& colours(std::int32_t level);
    /// All those that the runs ask for.
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
    std::optional<HeightFogView> height;  ///< of a fog that lies low
    World top = World::highest();         ///< nothing is in fog where eye and face are both above it
};

/// The fog from this view, if the level has one and the settings allow it.
FrameFog make_frame_fog(const FrameContext& frame);

/// Whether the eye and all that it sees, which is nowhere lower than `lowest`, are surely above the fog's top.
bool is_clear(World lowest, const FrameFog& fog, const Vec3<World>& eye);

/// False if each of these pixels of a face is surely clear: without fog, or where they and the eye are above its top.
bool may_have_fog(const VisibleFace& face, std::span<const Span> spans, const FrameContext& frame);

/// Appends the runs of spans of a face, clear ones too.
void append_runs(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, const FrameFog& fog,
                 std::vector<FogRun>& runs);

/// The row of colours for a thing at one pixel and depth. `runs` is scratch.
const ColourRow& fog_colours(std::int32_t column, std::int32_t row, InverseZ inverse_z, const FrameFog& fog,
                             std::vector<FogRun>& runs);

/// Finds the pixels of opaque faces that fog covers. Fog that lies low leaves the sky clear.
void find_fog(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
