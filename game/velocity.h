#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "game/state.h"

namespace oblong {

/// The largest whole number whose square is at most `square` (0 or more).
std::int64_t integer_root(std::int64_t square);

/// Length of a velocity, rounded down. Components up to 2^30 / sqrt 3 in size, which step_player() bounds.
World length_of(const Velocity& v);

/// a . b along a direction, rounded to nearest.
World dot(const Velocity& v, const Vec3<Unit>& direction);

/// v * part / whole, each component rounded toward zero. `whole` above 0.
Velocity scaled(const Velocity& v, World part, World whole);

/// v with what goes into a surface taken away, so that it slides along.
Velocity slide_along(const Velocity& v, const Vec3<Unit>& normal);

/// How far a velocity carries in one tick.
Place moved_in_a_tick(const Velocity& v);

}  // namespace oblong
