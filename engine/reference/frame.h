#pragma once

/// Which rays from the eye a polygon covers, in integers: rasterisation in homogeneous coordinates (Olano and Greer,
/// "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997).
///
/// A ray r is inside a triangle of corners a, b, c if it is a positive combination of them: if det(a, b, r), det(b, c,
/// r) and det(c, a, r) all have the sign of det(a, b, c). This also holds with corners behind the eye, so nothing is
/// clipped. A determinant is linear in the column, so that a row's rays inside are an interval.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/reference/view.h"

namespace oblong::reference {

__extension__ using Wide = __int128;

inline constexpr int kRayUnit = 4096;  ///< to the pixel

/// A corner in viewspace, right, down and ahead, right and down times the projection's multipliers, all in 2^-20. It
/// projects to x / z, y / z pixels from the optical centre.
struct RayCorner {
    std::int64_t x = 0, y = 0, z = 0;
};

/// Rounded to the nearest. Throws std::range_error from 2^35 on.
RayCorner make_ray_corner(const Vec& world_point, const Camera& camera);

/// An offset of all rays from the centres of their pixels: right, down; 1/4096 pixel.
struct RayShift {
    int x = 0, y = 0;
};

/// Rays through a picture's pixels: (x, y, kRayUnit), x and y 1/4096 pixel from the optical centre.
struct RayGrid {
    int width_px = 0, height_px = 0;
    RayShift shift;

    Wide x(int column) const { return std::int64_t{2 * column + 1 - width_px} * (kRayUnit / 2) + shift.x; }
    Wide y(int row) const { return std::int64_t{2 * row + 1 - height_px} * (kRayUnit / 2) + shift.y; }
};

/// Columns [first, end).
struct Interval {
    int first = 0, end = 0;
};

/// The rays that a triangle covers.
class RayTriangle {
  public:
    /// None if the eye is in its plane: then it covers no ray.
    static std::optional<RayTriangle> make(const RayCorner& a, const RayCorner& b, const RayCorner& c);

    /// 1 if the corners run clockwise in the view, -1 if counter-clockwise.
    int winding() const { return winding_; }
    /// A ray exactly on an edge counts if the triangle is to its right; on one along a row, if it is below.
    Interval inside(const RayGrid& grid, int row) const;

  private:
    /// det(from, to, ray) = x ray.x + y ray.y + z ray.z, above 0 inside.
    struct Side {
        Wide x = 0, y = 0, z = 0;
    };

    static Side side(const RayCorner& from, const RayCorner& to);
    static void limit(const Side& side, const RayGrid& grid, int row, Interval& interval);

    std::array<Side, 3> sides_;
    int winding_ = 1;
};

/// A polygon's triangles, all from its first corner. The windings of those that cover a ray add up to the polygon's: 1
/// where its front covers the ray, even if it is not quite convex.
std::vector<RayTriangle> make_ray_fan(std::span<const RayCorner> corners);

/// A brush model, 1 and up, moved by `offset`.
struct PlacedModel {
    int model = 0;
    Vec offset;
};

/// The contents of a pixel's centre. Without a face, only the flag is valid.
struct Pixel {
    int face = -1;               ///< of the level; -1: none
    int model = -1;              ///< of the face; 0: the world
    int plane = -1;              ///< into Frame::planes
    double z = 0;                ///< depth, units
    double u = 0, v = 0;         ///< texels of mip level 0, not wrapped; undefined for sky
    bool is_close_call = false;  ///< an edge passes very near the centre, or two faces are equally near
};

struct Frame {
    int width_px = 0, height_px = 0;
    std::vector<Pixel> pixels;      ///< rows top to bottom
    std::vector<PlaneView> planes;  ///< of the faces that pixels show

    const Pixel& at(int column, int row) const { return pixels[static_cast<std::size_t>(row * width_px + column)]; }
};

/// The world's faces and those of the models: for each ray the nearest one that faces the eye. `shift` moves all rays
/// from the pixels' centres, by half a pixel at most.
///
/// Which rays a face covers is exact: corners are rounded once, to 2^-20, then integers decide. Neighbours
/// share all corners, so that no ray from inside a closed level is missed; a ray through an edge belongs to the face on
/// its right, or below it. Nothing is clipped. Throws std::range_error for corners too far away for that (2^35 units
/// times pixels).
Frame draw(const Level& level, std::span<const PlacedModel> models, const View& view, RayShift shift = {});

/// draw() finds the close calls at equal depth. This also finds those at edges: where another face is `distance`
/// (1/4096 pixel) from the centre, to the right or left and below or above. It takes three times as long.
Frame draw_with_close_calls(const Level& level, std::span<const PlacedModel> models, const View& view,
                            int distance = kRayUnit / 512);

}  // namespace oblong::reference
