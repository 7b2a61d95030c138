#include "engine/level/floor.h"

#include <vector>

#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// A part of the vertical line that is still to be followed down the tree.
struct LinePart {
    NodeChild at;
    World high, low;
    PlaneIndex entered;  ///< the plane that it begins on; none: at the line's start
};

World crossing(const LevelPlane& plane, const Vec3<World>& high, const Vec3<World>& low) {
    const PlaneDistance above = plane_distance(plane, high), below = plane_distance(plane, low);
    return between(high.z, low.z, above, above - below);
}

/// Cos 45 degrees.
constexpr Unit kLeastUp = Unit::from_raw(759250125);

bool is_floor(const Level& level, NodeChild leaf, PlaneIndex entered) {
    return level.leaves[leaf.leaf()].contents == contents::kSolid && !entered.is_none() &&
           absolute(level.planes[entered].normal.z) >= kLeastUp;
}

}  // namespace

std::optional<Floor> find_floor(const Level& level, const Vec3<World>& from, World most) {
    const auto at_height = [&from](World z) { return Vec3<World>{from.x, from.y, z}; };
    const World low = saturated_to<World>(std::int64_t{from.z.raw} - most.raw);
    std::vector<LinePart> parts{{level.world().root, from.z, low, PlaneIndex::none()}};
    while (!parts.empty()) {
        LinePart part = parts.back();
        parts.pop_back();
        while (!part.at.is_leaf()) {
            const Node& node = level.nodes[part.at.node()];
            const LevelPlane& plane = level.planes[node.plane];
            const bool high_back = plane_side(plane, at_height(part.high)) < 0;
            const bool low_back = plane_side(plane, at_height(part.low)) < 0;
            part.at = node.children[high_back];
            if (high_back == low_back) continue;
            const World middle = crossing(plane, at_height(part.high), at_height(part.low));
            parts.push_back({node.children[low_back], middle, part.low, node.plane});
            part.low = middle;
        }
        const std::int32_t filling = level.leaves[part.at.leaf()].contents;
        if (is_floor(level, part.at, part.entered)) return Floor{part.entered, at_height(part.high)};
        if (filling == contents::kSolid || filling == contents::kSky) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace oblong
