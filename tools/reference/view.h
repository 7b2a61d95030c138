#pragma once

#include "tools/reference/vec.h"

namespace oblong::reference {

/// screen = centre + multiplier * view / z (y turned): Muratori's projection.
struct Projection {
    double width_px = 320, height_px = 200;
    double multiplier_x = 160, multiplier_y = 400.0 / 3;
};

/// Field of view in degrees across the width; `display` is width to height of the whole picture as shown.
Projection make_projection(double width_px, double height_px, double display, double field_of_view);

struct ScreenPoint {
    double x = 0, y = 0;
};

/// z above 0.
ScreenPoint project(const Vec& view, const Projection& projection);

/// Left-handed axes.
struct Axes {
    Vec right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
};

Vec to_view(const Vec& world_point, const Vec& world_eye, const Axes& axes);

/// The view of a picture. The world is Quake's: x east, y north, z up.
struct View {
    Vec eye;                              ///< not in solid; a face is invisible from its own plane
    double yaw = 0, pitch = 0, roll = 0;  ///< 1/65536 turn: counter-clockwise from +x seen from above; looking down;
                                          ///< leaning right
    double field_of_view = 90;            ///< degrees across the width
    int width_px = 320, height_px = 200;
    double display = 4.0 / 3;    ///< width to height of the whole picture as shown
    bool correct_aspect = true;  ///< false: drawn as if pixels were square
};

/// Values derived from a view: axes in the world, and the projection's two multipliers.
struct Camera {
    Vec eye;
    Axes axes;  ///< right, up, forward
    Projection projection;
};

Camera make_camera(const View& view);

}  // namespace oblong::reference
