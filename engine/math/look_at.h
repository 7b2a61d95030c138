#pragma once

#include "engine/math/basis.h"

namespace oblong {

enum class Handedness { Right, Left };

/// The axes of a view from `world_eye` to `world_target` whose up is as near to `up_hint` as possible (course notes).
/// `handedness` is the world's. Always orthonormal: where eye and target are equal, forward is perpendicular to the
/// hint; where the view is along the hint, or the hint is zero, up is some vector perpendicular to forward.
Basis look_at(const Vec3<World>& world_eye, const Vec3<World>& world_target, const Vec3<Unit>& up_hint,
              Handedness handedness = Handedness::Right);

}  // namespace oblong
