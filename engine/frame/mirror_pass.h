#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/level/level.h"
#include "engine/view/screen.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// The plane of a mirror, moved by `offset` with its brush model. The picture in it shows what is on the side that it
/// faces.
struct MirrorPlane {
    PlaneIndex plane;
    bool is_back = false;  ///< it faces the plane's back
    Vec3<World> offset;
    bool operator==(const MirrorPlane&) const = default;
};

/// The picture in a mirror: its plane, and the pixels of the flipped picture that it owns, or more.
struct MirrorView {
    MirrorPlane plane;
    ScreenRectangle pixels;
};

/// Whether a place is behind a mirror, so that it does not show it.
bool is_behind(const MirrorView& mirror, const Vec3<World>& place, const Level& level);

/// What views in mirrors are drawn with; empty until a frame shows one.
struct MirrorScratch {
    std::unique_ptr<ViewScratch> view;
    std::vector<std::uint8_t> picture;  ///< flipped
};

/// The most mirror planes of a frame: of more, the farther ones are drawn as walls.
inline constexpr std::size_t kMostMirrors = 4;

/// Draws what the frame's mirrors show, one level deep: mirrors in a mirror are walls. Each plane takes a picture of
/// its own from the mirrored eye, of which only the pixels that its faces own are drawn. Mirrored axes are left-handed
/// where the view's are right-handed; with `right` turned round they are a camera again, whose picture is flipped.
void draw_mirrors(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
