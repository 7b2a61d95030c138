#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/view/frustum.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// A view volume closed by a front and a back plane. Faces are drawn without these two; a line needs a front plane, for
/// it may pass beside the eye, where it has no place on the screen.
struct ViewVolume {
    std::array<ClipPlane, 6> planes;  ///< left, right, bottom, top, front, back
};
/// The bits of Outcode for the sides, and two more.
inline constexpr unsigned kOutFront = 16, kOutBack = 32;

/// The frustum from z = front to z = back; 0 < front < back, in view units.
ViewVolume make_view_volume(const Frustum& frustum, View front, View back);

/// A bit for each plane of the volume that a point in viewspace is outside of; on a plane is inside.
unsigned outcode_of(const ViewVolume& volume, const Vec3<View>& p);

/// A line between two points in viewspace. They are homogeneous coordinates: w is z, by which a point is divided to
/// reach the screen, so that lines are clipped before that division.
struct ViewLine {
    Vec3<View> from, to;
};

enum class LineClipping : std::uint8_t {
    CohenSutherland,  ///< an outcode for each end; cuts the line at one plane after the other, and rounds at each
    LiangBarsky       ///< where along the line it enters and leaves all planes; rounds each end once
};

/// The part of a line in the volume, each end within 2^-16 unit of its place by LiangBarsky; none if there is none.
/// Cohen and Sutherland: Newman and Sproull, "Principles of Interactive Computer Graphics"; Liang and Barsky, "A New
/// Concept and Method for Line Clipping", ACM Transactions on Graphics 3 (1984).
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line, LineClipping method);

/// The pixels of a mode in which a line begins and ends.
struct PixelLine {
    PixelPosition from, to;
};
/// Where a line is on the screen, by LiangBarsky; none if it is out of view. Its ends may be behind the eye.
std::optional<PixelLine> project_line(const ViewVolume& volume, const Projection& projection, const ViewLine& line);

}  // namespace oblong
