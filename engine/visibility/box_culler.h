#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/level/level.h"
#include "engine/raster/depth.h"
#include "engine/view/frustum.h"
#include "engine/view/outline.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

/// Sets of the frustum's sides, one bit each: left, right, bottom, top. kOutside instead of a set: outside one of them.
inline constexpr std::uint8_t kAllSides = 15, kOutside = 0xff;

/// Tests boxes against the sides of the frustum.
///
/// Along a plane's normal n the corners of a box lie from m - r to m + r, where m is n . (mins + maxs) / 2, and r is
/// |n| . (maxs - mins) / 2; |n| has the absolute values of n's components. Each takes three products of small integers.
/// All is doubled to avoid the division; the limits include the eye's distance, which is the same for all boxes.
class BoxCuller {
  public:
    BoxCuller(const Frustum& frustum, const Vec3<World>& eye);

    /// Which of `sides` the box crosses; kOutside if it lies outside one of them.
    std::uint8_t sides_crossed(const LevelBox& box, std::uint8_t sides) const {
        if (sides == 0) return sides;  // of most boxes; before the sums below
        const auto sum = [&box](std::size_t axis) { return Doubled{box.maxs[axis] + box.mins[axis]}; };
        const auto size = [&box](std::size_t axis) { return Doubled{box.maxs[axis] - box.mins[axis]}; };
        const Vec3<Doubled> sums{sum(0), sum(1), sum(2)}, sizes{size(0), size(1), size(2)};
        for (unsigned rest = sides; rest != 0; rest &= rest - 1) {
            const Side& side = item(sides_, std::countr_zero(rest));
            const CullPlane::Component middle = dot(side.normal, sums), reach = dot(side.abs_normal, sizes);
            note_range<"box's cull distance">(middle + reach);
            note_range<"box's cull distance">(middle - reach);
            if (middle + reach < side.outside) return kOutside;
            if (middle - reach >= side.inside) sides ^= static_cast<std::uint8_t>(rest & -rest);
        }
        return sides;
    }

  private:
    /// Twice a coordinate or a distance, in whole units.
    using Doubled = Fixed<std::int32_t, 0>;
    using Component = Fixed<std::int32_t, CullPlane::Component::kFractionBits>;

    struct Side {
        Vec3<Component> normal, abs_normal;
        CullPlane::Component outside, inside;  ///< doubled, from the world's origin; rounded up, compared with "<"
    };

    std::array<Side, 4> sides_;
};

/// A rectangle that holds every pixel where something in the box may be drawn, one pixel larger for rounding; empty if
/// there is none. If the box reaches the eye's plane or is near it, the rectangle reaches the screen's border.
ScreenRectangle rectangle_of(const LevelBox& box, const ViewContext& view);

/// The same as rectangle_of(), but closer around a box that is seen aslant.
ScreenOutline outline_of(const LevelBox& box, const ViewContext& view);

/// 1/z of the corner of a box that is nearest along the view.
InverseDepth nearest_inverse_depth_of(const LevelBox& box, const ViewContext& view);
InverseDepth nearest_inverse_depth_of(const ViewBox& box);

/// A box that holds something which does not move, with the world's open leaves that it reaches into.
struct PlacedBox {
    LevelBox box;
    std::vector<LeafIndex> leaves;  ///< empty if has_many_leaves
    bool has_many_leaves = false;   ///< too many to list: one of them is nearly always visible
};

/// Finds the leaves by descending the tree; call it once a level, not once a frame.
PlacedBox place_box(const Level& level, const LevelBox& box);

/// False if none of its leaves is in `leaves`.
bool reaches(const PlacedBox& placed, const LeafSet& leaves);

/// False if the box is outside the view, or none of its leaves is in `leaves`.
bool may_be_seen(const PlacedBox& placed, const LeafSet& leaves, const BoxCuller& culler);

}  // namespace oblong
