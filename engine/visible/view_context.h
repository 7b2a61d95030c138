#pragma once

#include "engine/camera/frustum.h"
#include "engine/geometry/project.h"
#include "engine/math/basis.h"
#include "engine/screen/projection.h"

namespace oblong {

/// All that a frame transforms its vertices with.
struct ViewContext {
    Vec3<World> eye;
    Basis axes;
    Projection lens;
    Frustum frustum;
    SubpixelGrid grid;
};

}  // namespace oblong
