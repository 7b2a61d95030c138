#pragma once

#include "engine/math/basis.h"

namespace oblong {

enum class Handedness { Right, Left };

/// The axes of a view from `world_eye` to `world_target` whose up leans toward `up_hint` as far as it can (course
/// notes). `handedness` is the world's. Always orthonormal: an eye in its target looks level, that is at right angles
/// to the hint; a view along the hint, or no hint at all, has some up at right angles to the view.
Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness = Handedness::Right);

}  // namespace oblong
