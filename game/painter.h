#pragma once

#include <cstdint>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "game/load.h"
#include "game/stage.h"
#include "game/view.h"

namespace oblong {

/// Draws moments of a game into a canvas of its own.
class Painter {
  public:
    /// `data` and `stage` outlive the painter.
    Painter(const GameData& data, const Stage& stage, const ScreenMode& mode);

    void draw(const Moment& moment, const Camera& camera, const Settings& settings);
    Framebuffer canvas();
    const ScreenMode& mode() const { return mode_; }

  private:
    const GameData& data_;
    const Stage& stage_;
    ScreenMode mode_;
    FrameWorkspace work_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace oblong
