#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/basis.h"
#include "engine/view/gradients.h"
#include "engine/view/projection.h"

namespace oblong {

/// A component of a direction of view: 34.30.
using DirectionPart = Fixed<std::int64_t, 30>;

/// The directions through pixel centres in world axes, scaled to a depth of one unit: linear on the screen.
struct ViewDirections {
    LinearQuantity<DirectionPart> x, y, z;
};

ViewDirections make_view_directions(const Basis& axes, const Projection& projection);

}  // namespace oblong
