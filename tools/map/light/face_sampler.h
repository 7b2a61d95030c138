#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/map/light/tracer.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// A face's corners in order, and the direction that it faces.
Winding face_corners(const BspFile& bsp, const FileFace& face);
Point face_normal(const BspFile& bsp, const FileFace& face);

/// The samples of a face's lightmap: at multiples of 16 texels, from the one at or below its corners' least texel to
/// the one at or above the greatest.
struct LightGrid {
    static constexpr int kStep = 16;
    std::array<int, 2> first{};  ///< in steps: texel / kStep
    std::array<int, 2> count{};
};
LightGrid light_grid(const BspFile& bsp, const FileFace& face);

/// How light is interpolated over a face; both are empty for a face that is lit flat.
struct SmoothFace {
    std::vector<Point> normals;  ///< at its corners
    std::vector<int> across;     ///< from each corner to the next: the face beyond, if it has the same normals; else -1
};

/// A point over a surface, and the normal for light there.
struct LitPoint {
    Point point, normal;
};

class FaceSampler;
using FaceSamplers = std::vector<std::optional<FaceSampler>>;  ///< by face; none: no lightmap

/// The points at which the samples of a face's lightmap are measured.
class FaceSampler {
  public:
    /// `all` must outlive it, and be complete before place_at() is called.
    FaceSampler(const BspFile& bsp, const FileFace& face, SmoothFace smooth, const FaceSamplers& all,
                const Tracer& tracer);

    const Point& normal() const { return normal_; }
    const LightGrid& grid() const { return grid_; }
    const Point& centre() const { return centre_; }
    double radius() const { return radius_; }

    bool is_smooth() const { return !smooth_.normals.empty(); }

    /// The point, kLift above the face, at sample (u, v) of the grid (fractions: between samples). Where light is
    /// smooth across an edge, a point beyond it is over the next face. A point inside or behind a wall moves to the
    /// nearest point above the face.
    LitPoint place_at(double u, double v) const;

    /// The index of the sample that is nearest to a point of the face's plane; none if the point is not on the face.
    std::optional<std::size_t> sample_at(const Point& point) const;

  private:
    static constexpr double kLift = 1, kInset = 1, kSlack = 1.0 / 64;

    Point nearest_over_face(const Point& point) const;
    Point normal_at(const Point& point) const;

    const Tracer& tracer_;
    const FaceSamplers& all_;
    LightGrid grid_;
    Point normal_;
    std::vector<Point> corners_;  // lifted
    std::vector<Plane> edges_;    // perpendicular to the face through its edges, facing outward
    SmoothFace smooth_;
    std::array<Point, 2> axes_;  // of texels
    std::array<double, 2> offsets_{};
    Point centre_;  // of the lifted corners
    double radius_ = 0;
    Point base_, step_u_, step_v_;
};

/// The normals at each face's corners for light (the faces stay flat). If a face's texinfo has an angle above 0 in
/// `surfaces`, a corner's normal is the mean of the normals of all such faces of its group at this corner, weighted by
/// their angles there, except those that differ from this face's by more than the smaller of both faces' limits.
std::vector<SmoothFace> smooth_faces(const BspFile& bsp, const std::vector<SurfaceLight>& surfaces);

/// The name of a face's texture, in lower case.
std::string texture_name(const BspFile& bsp, const FileFace& face);

/// The groups of meant faces (as indices) that the compiler cut from one surface: they have the same plane, facing and
/// texture alignment, and share edges. In the order of their first faces.
std::vector<std::vector<int>> whole_surfaces(const BspFile& bsp, const std::function<bool(const FileFace&)>& is_meant);

}  // namespace oblong::map
