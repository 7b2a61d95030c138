#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tools/map/light/tracer.h"

namespace oblong::map {

/// A face's corners in order, and the direction that it faces.
std::vector<Floats> face_corners(const BspFile& bsp, const FileFace& face);
Point face_normal(const BspFile& bsp, const FileFace& face);

/// The samples of a face's lightmap: at every 16th texel, from the multiple of 16 at or below the least texel of its
/// corners to the one at or above the greatest.
struct LightGrid {
    static constexpr int kStep = 16;
    std::array<int, 2> first{};  ///< in steps: texel / kStep
    std::array<int, 2> count{};
};
LightGrid light_grid(const BspFile& bsp, const FileFace& face);

/// Where light is measured for the samples of a face's lightmap.
class FaceSampler {
  public:
    /// `corner_normals`: of light, one a corner; empty: the face's own everywhere.
    FaceSampler(const BspFile& bsp, const FileFace& face, std::vector<Point> corner_normals, const Tracer& tracer);

    const Point& normal() const { return normal_; }
    const LightGrid& grid() const { return grid_; }
    const Point& centre() const { return centre_; }
    double radius() const { return radius_; }

    /// The point, kLift over the face, at sample (u, v) of the grid (fractions lie between samples). One that is
    /// inside of a wall or beyond it moves to the nearest point over the face itself.
    Point point_at(double u, double v) const;

    /// The normal that light meets at a point over the face.
    Point normal_at(const Point& point) const;

    /// The index of the sample that is nearest to a point of the face's plane; none where it is not on the face.
    std::optional<std::size_t> sample_at(const Point& point) const;

  private:
    static constexpr double kLift = 1, kInset = 1, kSlack = 1.0 / 64;

    Point nearest_over_face(const Point& point) const;

    const Tracer& tracer_;
    LightGrid grid_;
    Point normal_;
    std::vector<Point> corners_;  // lifted
    std::vector<Plane> edges_;    // stand on the face along its edges, and face away from it
    std::vector<Point> corner_normals_;
    std::array<Point, 2> axes_;  // of texels
    std::array<double, 2> offsets_{};
    Point centre_;  // of the lifted corners
    double radius_ = 0;
    Point base_, step_u_, step_v_;
};

}  // namespace oblong::map
