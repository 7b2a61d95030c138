#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/level/level.h"
#include "engine/view/frustum.h"

namespace oblong {

/// All sides of a view, a bit each: left, right, bottom, top; and in place of sides: outside of one of them.
inline constexpr std::uint8_t kAllSides = 15, kOutside = 0xff;

/// Compares boxes with the sides of a view.
///
/// Along a plane's normal n the corners of a box lie from m - r to m + r, where m is n . (mins + maxs) / 2, and r is
/// |n| . (maxs - mins) / 2, with |n| the normal whose components have lost their signs. So both ends take six products
/// of small integers: all is doubled, and the limits hold what is the same for all boxes, the distance of the eye.
class BoxCuller {
  public:
    BoxCuller(const Frustum& frustum, const Vec3<World>& eye);

    /// Which of `planes` the box still crosses; kOutside if it lies outside of one.
    std::uint8_t planes_crossed(const LevelBox& box, std::uint8_t planes) const {
        const auto sum = [&box](std::size_t axis) { return box.maxs[axis] + box.mins[axis]; };
        const auto size = [&box](std::size_t axis) { return box.maxs[axis] - box.mins[axis]; };
        const Doubled sums{sum(0), sum(1), sum(2)}, sizes{size(0), size(1), size(2)};
        for (unsigned rest = planes; rest != 0; rest &= rest - 1) {
            const Side& plane = at(sides_, std::countr_zero(rest));
            const Distance middle = along(plane.normal, sums), reach = along(plane.slope, sizes);
            note_range<"box's cull distance">(middle + reach);
            note_range<"box's cull distance">(middle - reach);
            if (middle + reach < plane.outside) return kOutside;
            if (middle - reach >= plane.inside) planes ^= static_cast<std::uint8_t>(rest & -rest);
        }
        return planes;
    }

  private:
    /// Twice a coordinate in whole units, or twice a distance of such.
    using Doubled = std::array<std::int64_t, 3>;
    using Distance = CullPlane::Component;

    struct Side {
        Vec3<Distance> normal, slope;  ///< `slope` without signs
        Distance outside, inside;      ///< doubled, from the world's origin; rounded up, as they are compared with "<"
    };

    static Distance along(const Vec3<Distance>& normal, const Doubled& v) {
        return normal.x * v[0] + normal.y * v[1] + normal.z * v[2];
    }

    std::array<Side, 4> sides_;
};

}  // namespace oblong
