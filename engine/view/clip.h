#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/scratch.h"
#include "engine/view/frustum.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// A polygon's corner during clipping. The sets have Outcode's bits.
///
/// A corner that was clipped to a side projects exactly onto that border of the screen, even if it is so near to the
/// eye that its position is coarse. A new corner is outside of the sides that both ends of its edge are outside of, and
/// inside those that both are inside; only sides between the ends are tested with its rounded position. So all faces
/// that share an edge keep the same part of it.
struct ClipVertex {
    Vec3<View> position;
    std::uint8_t borders = 0;       ///< sides to which it was clipped
    std::uint8_t outcode = 0;       ///< sides that it is outside of, without undecided ones
    std::uint8_t undecided = 0xff;  ///< sides still to be tested with its position
    bool is_projected = false;
    ScreenVertex screen{};  ///< if is_projected
};

/// Where the edge from `inside` to `outside` crosses a plane, from both distances to it. Always computed from the
/// inside vertex: the two faces of an edge traverse it in opposite directions and get the same bits (hard case C2).
Vec3<View> cross_plane(const Vec3<View>& inside, ClipDistance distance_inside, const Vec3<View>& outside,
                       ClipDistance distance_outside);

/// Clips a convex polygon plane by plane (Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17, 1974). Its
/// corners are pointers, as faces share them.
class PolygonClipper {
  public:
    /// Starts a polygon; its corners are to be written to the result, in order.
    std::span<ClipVertex*> start(std::size_t corner_count) { return corners_ = buffers_[current_].take(corner_count); }
    /// Allocates for polygons of up to this many corners, and what clipping adds.
    void reserve(std::size_t corner_count) {
        for (auto& buffer : buffers_) buffer.take(2 * (corner_count + kClipPlaneCount));
    }
    /// Clips to one plane; new corners get `border`, the plane's bit in outcodes. A corner on the plane is inside (hard
    /// case C1).
    void clip_to_plane(const ClipPlane& plane, std::uint8_t border);
    /// Clips to the planes in `outcodes` (the union of its corners' outcodes). The result is empty, or has at most one
    /// more corner for each plane.
    void clip(const Frustum& frustum, unsigned outcodes);
    /// The clipped polygon; valid until the next start().
    std::span<ClipVertex* const> corners() const { return corners_; }

  private:
    std::array<Scratch<ClipVertex*>, 2> buffers_;
    std::size_t current_ = 0;  ///< buffer of `corners_`
    std::span<ClipVertex*> corners_;
    std::deque<ClipVertex> made_;  ///< new corners; a deque keeps their addresses
};

/// A polygon with its own corners, and its clipper.
struct ClipScratch {
    std::vector<ClipVertex> polygon, other;
    PolygonClipper clipper{};
};

/// PolygonClipper::clip() for `scratch.polygon`.
void clip_polygon(const Frustum& frustum, unsigned outcodes, ClipScratch& scratch);

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
