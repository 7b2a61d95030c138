#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "engine/base/scratch.h"
#include "engine/view/frustum.h"
#include "engine/view/screen.h"

namespace oblong {

/// A polygon's corner during clipping. `borders` are the sides of the view on which clipping put it (Outcode's bits):
/// there it projects exactly onto the screen's border, however near to the eye it lies and however coarse its position
/// therefore is. Which sides it is outside of is decided once: a corner that clipping makes on an edge is on the side
/// of a plane that both ends of the edge are on, whatever its rounded position says. So all faces that share an edge,
/// whatever their other corners, keep the same part of it.
struct ClipVertex {
    Vec3<View> position;
    std::uint8_t borders = 0;
    std::uint8_t outcode = 0;       ///< the sides that it is outside of, among those decided
    std::uint8_t undecided = 0xff;  ///< the sides still to be tested by its position
    bool is_projected = false;
    ScreenVertex screen{};  ///< where is_projected
};

/// Where the edge from `inside` to `outside` crosses a plane, given both distances to it. Always computed from the
/// inside vertex: the two faces that share an edge walk it in opposite directions and get the same bits (hard case C2).
Vec3<View> cross_plane(const Vec3<View>& inside, ClipDistance distance_inside, const Vec3<View>& outside,
                       ClipDistance distance_outside);

/// Clips a convex polygon plane by plane. It is a list of corners that are kept elsewhere and not copied: faces share
/// them. Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17 (1974).
class PolygonClipper {
  public:
    /// Room for the corners of a new polygon, in order.
    std::span<ClipVertex*> start(std::size_t corner_count) { return corners_ = buffers_[current_].take(corner_count); }
    /// Has room for polygons of so many corners, and what clipping adds.
    void reserve(std::size_t corner_count) {
        for (auto& buffer : buffers_) buffer.take(2 * (corner_count + kClipPlaneCount));
    }
    /// Clips to one plane; corners put on it get `border`, which is also the plane's bit in outcodes. A corner on the
    /// plane is inside (hard case C1).
    void clip_to_plane(const ClipPlane& plane, std::uint8_t border);
    /// Clips to the planes in `outcodes` (the union of its corners' outcodes). Perhaps nothing is left; else there is
    /// at most one corner more for each plane.
    void clip(const Frustum& frustum, unsigned outcodes);
    /// What is left. Valid until the next polygon is started.
    std::span<ClipVertex* const> corners() const { return corners_; }

  private:
    std::array<Scratch<ClipVertex*>, 2> buffers_;
    std::size_t current_ = 0;  ///< the buffer that the corners are in
    std::span<ClipVertex*> corners_;
    std::deque<ClipVertex> made_;  ///< by clipping: these stay where they are
};

/// A polygon with its own corners, and what clips it.
struct ClipScratch {
    std::vector<ClipVertex> polygon, other;
    PolygonClipper clipper{};
};

/// PolygonClipper::clip() for `scratch.polygon`.
void clip_polygon(const Frustum& frustum, unsigned outcodes, ClipScratch& scratch);

}  // namespace oblong
