#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/view/frustum.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// A view volume with a front and a back plane. Faces are drawn without these two; a line needs a front plane, as it
/// may pass beside the eye, where it has no projection.
struct ViewVolume {
    std::array<ClipPlane, 6> planes;  ///< left, right, bottom, top, front, back
};
/// The frustum from z = front to z = back; 0 < front < back, in view units.
ViewVolume make_view_volume(const Frustum& frustum, View front, View back);

/// A line between two points in viewspace, clipped before the division by z.
struct ViewLine {
    Vec3<View> from, to;
};

/// Half a distance, so that differences of two fit; its sign is exact.
ClipDistance half_distance(const ClipPlane& plane, const Vec3<View>& p);

/// The part of a line in the volume, each end rounded once, within 2^-16 unit of the exact one; none if it is outside.
/// From the parameters at which the line enters and leaves: Liang and Barsky, "A New Concept and Method for Line
/// Clipping", ACM Transactions on Graphics 3 (1984).
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line);

/// A line's first and last pixel.
struct PixelLine {
    PixelPosition from, to;
};
/// Clips and projects a line, whose ends may be behind the eye; none if it is out of view.
std::optional<PixelLine> project_line(const ViewVolume& volume, const Projection& projection, const ViewLine& line);

}  // namespace oblong
