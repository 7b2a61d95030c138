#include "engine/math/look_at.h"

#include "engine/math/vec.h"

namespace oblong {

namespace {

Vec3<Unit> direction_between(const Vec3<World>& from, const Vec3<World>& to) {
    return normalised(widening_difference(to, from));
}

}  // namespace

Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness) {
    constexpr Vec3<Unit> kNone{};
    Basis result;
    result.forward = direction_between(world_eye, world_target);
    if (result.forward == kNone) result.forward = perpendicular_to(up_hint);
    Vec3<Unit> right = normalised(cross(result.forward, up_hint));
    if (right == kNone) right = perpendicular_to(result.forward);
    result.up = normalised(cross(right, result.forward));
    result.right = handedness == Handedness::Right ? right : -right;
    return result;
}

}  // namespace oblong
