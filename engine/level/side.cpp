#include "engine/level/side.h"

namespace oblong {

namespace {

template <class Number>
constexpr int sign_of(Number value) {
    return (value > Number{}) - (value < Number{});
}

World coordinate(const Vec3<World>& p, std::uint8_t axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The part of normal . p - distance that plane_distance() omits, in units of 2^-72: below 2^62, as each rest is at
/// most 2^29 and each coordinate 2^31.
std::int64_t distance_rest_72(const LevelPlane& plane, Vec3<World> p) {
    const auto [x, y, z] = raw_of(p);
    return x * plane.normal_rest_60[0] + y * plane.normal_rest_60[1] + z * plane.normal_rest_60[2] -
           plane.distance_rest_72;
}

}  // namespace

int plane_side(const LevelPlane& plane, Vec3<World> p) {
    if (plane.axis < 3 && plane.distance_rest_72 == 0)
        return sign_of(convert<PlaneDistance>(coordinate(p, plane.axis)) - plane.distance);

    // The rest is below 2^62 in units of 2^-72, which is 2^32 in units of 2^-42; it matters only if the distance is
    // smaller.
    const std::int64_t distance = plane_distance(plane, p).raw;
    constexpr std::int64_t kUndecided = std::int64_t{1} << 32;
    if (distance >= kUndecided || distance <= -kUndecided) return sign_of(distance);
    return sign_of(distance * (std::int64_t{1} << 30) + distance_rest_72(plane, p));
}

bool is_behind(const LevelPlane& plane, bool is_back, const Vec3<World>& p) {
    return distance_before(plane, is_back, p) <= PlaneDistance{};
}

LeafIndex find_leaf(const Level& level, const SubModel& model, Vec3<World> p) {
    NodeChild child = model.root;
    while (!child.is_leaf()) {
        const Node& node = level.nodes[child.node()];
        child = node.children[plane_side(level.planes[node.plane], p) > 0 ? 0 : 1];
    }
    return child.leaf();
}

}  // namespace oblong
