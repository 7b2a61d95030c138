#pragma once

#include "tools/map/light_grid.h"
#include "tools/map/light_trace.h"

namespace oblong::map {

/// Where light is measured for the samples of a face's lightmap.
class FaceSampler {
  public:
    FaceSampler(const BspFile& bsp, const FileFace& face, const Tracer& tracer);

    const Point& normal() const { return normal_; }
    const LightGrid& grid() const { return grid_; }
    const Point& centre() const { return centre_; }
    double radius() const { return radius_; }

    /// The point, kLift over the face, at sample (u, v) of the grid (fractions lie between samples). One that is
    /// inside of a wall or beyond it moves to the nearest point over the face itself.
    Point point_at(double u, double v) const;

  private:
    static constexpr double kLift = 1, kInset = 1;

    Point nearest_over_face(const Point& point) const;

    const Tracer& tracer_;
    LightGrid grid_;
    Point normal_;
    std::vector<Point> corners_;  // lifted
    Point centre_;                // of the lifted corners
    double radius_ = 0;
    Point base_, step_u_, step_v_;
};

}  // namespace oblong::map
