#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/workspace.h"
#include "engine/level/level.h"
#include "engine/reference/level.h"
#include "engine/scene/placed_models.h"
#include "engine/surface/palette.h"
#include "engine/view/projection.h"

namespace oblong {

/// A level as the engine and as the reference read it, and the cameras whose frames are measured.
struct MeasuredLevel {
    std::string name;
    std::string about;  ///< why it is hard; empty for a user's level
    Level level;
    reference::Level exact;
    std::vector<PlacedModel> models;
    std::vector<Camera> cameras;
};

/// From the bytes of a level file. Eyes are moved off planes first, as in frames (engine/visibility/eye.h), so that
/// both see from the same place. Throws InputError.
MeasuredLevel make_measured_level(const std::string& name, const std::string& about, std::span<const std::uint8_t> file,
                                  std::vector<Camera> cameras);

/// All frames are of this mode.
inline constexpr ScreenMode kMeasuredMode;

/// The frames of a level, with a workspace for each way of lighting surfaces, so that settings drawn in turn do not
/// evict each other's surfaces.
class LevelFrames {
  public:
    /// `level` and `colormap` must outlive it.
    LevelFrames(const MeasuredLevel& level, const Colormap& colormap);

    const MeasuredLevel& level() const { return level_; }
    std::span<const std::uint8_t> pixels() const { return pixels_; }  ///< of the last frame

    void draw(const Camera& camera, const Accuracy& accuracy, EffectSet effects = kStillEffects);
    /// Whether tall pixels are drawn for, as they are at first (Settings::correct_aspect).
    void correct_aspect(bool corrects) { corrects_aspect_ = corrects; }
    /// Makes the next frame of these settings build all its surfaces.
    void forget_surfaces(const Accuracy& accuracy);
    /// Draws; returns the contents of each pixel, valid until the next call.
    const FrameRecord& record(const Camera& camera, const Accuracy& accuracy);
    /// Draws; returns the counts of the stages.
    FrameCounts count(const Camera& camera, const Accuracy& accuracy);

  private:
    struct Lighting {
        Accuracy accuracy;
        std::unique_ptr<FrameWorkspace> work;
    };

    FrameWorkspace& workspace_for(const Accuracy& accuracy);

    const MeasuredLevel& level_;
    const Colormap& colormap_;
    std::vector<Lighting> lightings_;
    bool corrects_aspect_ = true;
    FrameRecord record_;
    std::vector<std::uint8_t> pixels_;
};

/// Small levels compiled at run time, each hard for approximations, in the demo level's colours: a wall with depths of
/// 1:10 and 1:1000 across the screen, a wall close by, a floor to the horizon, a tilted plane, slivers, a tower far
/// away, a sphere of many facets from several sides. At most `most_cameras` of each.
std::vector<MeasuredLevel> make_hard_scenes(const Palette& palette, std::size_t most_cameras);

}  // namespace oblong
