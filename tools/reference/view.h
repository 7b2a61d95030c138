#pragma once

#include "tools/reference/projection.h"

namespace oblong::reference {

/// Where a picture is seen from. The world is Quake's: x east, y north, z up.
struct View {
    Vec eye;                              ///< in the open; on the plane of a face it does not see that face
    double yaw = 0, pitch = 0, roll = 0;  ///< 1/65536 turn: counter-clockwise from +x seen from above; looking down;
                                          ///< leaning right
    double field_of_view = 90;            ///< degrees across the width
    int width_px = 320, height_px = 200;
    double display = 4.0 / 3;    ///< width to height of the whole picture as shown
    bool correct_aspect = true;  ///< false: drawn as if pixels were square
};

/// What follows from a view: axes in the world, and the projection's two multipliers.
struct Camera {
    Vec eye;
    Axes axes;  ///< right, up, forward
    Projection projection;
};

Camera make_camera(const View& view);

}  // namespace oblong::reference
