#pragma once

#include "engine/geometry/frustum.h"
#include "engine/geometry/project.h"
#include "engine/geometry/projection.h"
#include "engine/math/basis.h"

namespace oblong {

/// Everything that a frame transforms its vertices with.
struct ViewContext {
    Vec3<World> eye;
    Basis axes;
    Projection projection;
    Frustum frustum;
    SubpixelGrid grid;
    std::int32_t view_bits = View::kFractionBits;  ///< of positions in viewspace
};

}  // namespace oblong
