#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/level/level.h"
#include "engine/view/screen.h"

namespace oblong {

struct ViewScratch;

/// The plane of a mirror, moved by `offset` with its brush model. It shows what is on the side that it faces.
struct MirrorPlane {
    PlaneIndex plane;
    bool is_back = false;  ///< faces the plane's back
    Vec3<World> offset;
    bool operator==(const MirrorPlane&) const = default;
};

/// The view in a mirror, and a rectangle around its pixels in the flipped picture.
struct MirrorView {
    MirrorPlane plane;
    ScreenRectangle pixels;
};

/// Whether a place is behind a mirror, and so not shown in it.
bool is_behind(const MirrorView& mirror, const Vec3<World>& place, const Level& level);

/// Scratch for mirrors' views; empty until a frame shows a mirror.
struct MirrorScratch {
    std::unique_ptr<ViewScratch> view;
    std::vector<std::uint8_t> picture;  ///< flipped
};

}  // namespace oblong
