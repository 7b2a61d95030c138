#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "tools/accuracy/measured_level.h"

namespace oblong {

/// All frames are of this mode.
inline constexpr ScreenMode kMeasuredMode;

/// The frames of a level, with a workspace for each way of lighting surfaces, so that settings drawn in turn do not
/// throw each other's surfaces away.
class LevelFrames {
  public:
    /// `level` and `colormap` must outlive it.
    LevelFrames(const MeasuredLevel& level, const Colormap& colormap);

    const MeasuredLevel& level() const { return level_; }
    std::span<const std::uint8_t> pixels() const { return pixels_; }  ///< of the last frame

    void draw(const Camera& camera, const Accuracy& accuracy, EffectSet effects = kStillEffects);
    /// Makes the next frame of these settings build all its surfaces.
    void forget_surfaces(const Accuracy& accuracy);
    /// Draws; what each pixel shows, until the next call.
    const FrameRecord& record(const Camera& camera, const Accuracy& accuracy);
    /// Draws; what the stages did.
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
    FrameRecord record_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace oblong
