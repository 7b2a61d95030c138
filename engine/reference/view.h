#pragma once

#include <optional>

#include "engine/reference/level.h"
#include "engine/reference/vec.h"

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

struct Texel {
    double u = 0, v = 0, inverse_z = 0;
};

/// The unbounded plane of a face in a view: maps screen positions to texels, and back.
///
/// Along the ray r = right X / mx - up Y / my + forward, X and Y pixels from the optical centre, the point at depth z
/// is eye + z r. So u is linear in z dot(s, r); and as that point is on the plane, 1/z = -dot(normal, r) / distance of
/// the eye, which is linear in X and Y.
class PlaneView {
  public:
    /// `offset`: the displacement of the face's model.
    PlaneView(const Level& level, const Face& face, const Vec& offset, const Camera& camera);

    double inverse_z(ScreenPoint at) const { return inverse_z_.at(from_centre(at)); }
    /// The texel of the plane, at its own depth. Requires inverse_z() above 0.
    Texel texel_at(ScreenPoint at) const { return texel_at(at, inverse_z(at)); }
    /// The texel of the point at another depth of the same ray.
    Texel texel_at(ScreenPoint at, double inverse_z) const;
    /// The place on the screen at which the plane shows a texel; none if that is not in front of the eye, or if the
    /// texture's axes do not separate the plane's points. Its distance to the centre of the pixel where a renderer
    /// shows this texel is that renderer's error there, in pixels.
    std::optional<ScreenPoint> place_of(double u, double v) const;

  private:
    /// x X + y Y + constant, pixels from the optical centre.
    struct Linear {
        double x = 0, y = 0, constant = 0;
        double at(ScreenPoint p) const { return x * p.x + y * p.y + constant; }
    };

    static Linear along_ray(const Vec& axis, const Camera& camera);
    ScreenPoint from_centre(ScreenPoint at) const { return {at.x - centre_.x, at.y - centre_.y}; }

    ScreenPoint centre_;
    double eye_u_ = 0, eye_v_ = 0;
    Linear u_along_ray_, v_along_ray_, inverse_z_;
};

}  // namespace oblong::reference
