#pragma once

#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/level/level.h"

namespace oblong {

/// normal . p - distance to 42 fraction bits, in world units: within 2^-10 units of the exact value (2^-17 for
/// points within 4,096 units of the origin), as the rests of LevelPlane are left out. Any p, any plane that the level
/// reader accepts.
inline std::int64_t plane_distance_42(const LevelPlane& plane, Vec3<World> p) {
    // Below 0.9 * 2^62 (a point of length 0.87 * 2^32 by a normal of 1.03 * 2^30) plus 2^62. But part sums need not be.
    const auto product = [](World a, Unit b) { return static_cast<std::uint64_t>(std::int64_t{a.raw} * b.raw); };
    const std::uint64_t sum =
        product(p.x, plane.normal.x) + product(p.y, plane.normal.y) + product(p.z, plane.normal.z);
    const auto distance = static_cast<std::int64_t>(sum - static_cast<std::uint64_t>(plane.distance.raw));
    note_range<Quantity::DistanceToPlane>(distance);
    return distance;
}

/// The exact side of a point, by all the bits that LevelPlane keeps of the file's floats: +1 in front (normal . p >
/// distance), 0 on the plane, -1 behind.
int plane_side(const LevelPlane& plane, Vec3<World> p);

/// The leaf of a model that holds a point: down the front child where plane_side is +1, else down the back one, so
/// that a point on a plane belongs to its back. `p` is in the model's own coordinates.
LeafIndex find_leaf(const Level& level, const SubModel& model, Vec3<World> p);

}  // namespace oblong
