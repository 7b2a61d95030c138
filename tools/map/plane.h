#pragma once

#include <map>
#include <vector>

#include "tools/map/point.h"

namespace oblong::map {

/// normal . p = distance; its front is where normal . p is larger.
struct Plane {
    Point normal;
    double distance = 0;

    double height_of(const Point& point) const { return dot(normal, point) - distance; }
    Plane flipped() const { return {-normal, -distance}; }
};

/// The plane's kind in the level file: 0, 1, 2 if the normal is exactly +x, +y, +z, else 3 + its longest component's
/// axis.
int plane_type(const Plane& plane);

inline bool is_axial(const Plane& plane) {
    return plane_type(plane) < 3;
}

/// One side of a plane in a PlaneList: `is_back` faces against the normal.
struct PlaneSide {
    int plane = 0;
    bool is_back = false;

    PlaneSide opposite() const { return {plane, !is_back}; }
    auto operator<=>(const PlaneSide&) const = default;
};

/// All planes of a level, each once and with its longest component positive, so that planes which should be the same
/// are.
class PlaneList {
  public:
    /// The side that `plane` is, within kNormalEpsilon and kDistanceEpsilon; nearly axial normals become axial, and
    /// their nearly whole distances whole.
    PlaneSide find_or_add(const Plane& plane);

    const Plane& operator[](int index) const { return planes_[static_cast<std::size_t>(index)]; }
    Plane facing(PlaneSide side) const { return side.is_back ? (*this)[side.plane].flipped() : (*this)[side.plane]; }
    int count() const { return static_cast<int>(planes_.size()); }

    static constexpr double kNormalEpsilon = 1e-6;
    static constexpr double kDistanceEpsilon = 1.0 / 512;

  private:
    int find(const Plane& plane) const;

    std::vector<Plane> planes_;
    std::map<long, std::vector<int>> by_distance_;  // whole distance -> planes
};

}  // namespace oblong::map
