#pragma once

#include "engine/fixed/angle.h"
#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// Eye, orientation, horizontal field of view. Yaw counter-clockwise from +x seen from above, pitch positive looking
/// down, roll positive leaning right (Quake's).
struct Camera {
    Vec3<World> eye;
    Angle yaw, pitch, roll;
    Degrees field_of_view = Degrees::from_int(90);  ///< across the whole width; 1 to 179
};

}  // namespace oblong
