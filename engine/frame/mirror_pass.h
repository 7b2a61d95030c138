#pragma once

#include <cstddef>

namespace oblong {

struct Claims;
struct FrameContext;
struct ViewScratch;

/// The most mirror planes of a frame; further ones are walls.
inline constexpr std::size_t kMostMirrors = 4;

/// Moves the faces of all mirror planes but the first kMostMirrors to the walls.
void limit_mirrors(const FrameContext& frame, Claims& claims);

/// Draws the frame's mirrors, one level deep: mirrors in a mirror are walls. For each plane a picture is drawn from the
/// mirrored eye, only at the pixels that its faces own. Reflection reverses the handedness of the axes; with `right`
/// negated they are a camera's again, whose picture is flipped.
void draw_mirrors(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
