#include "tools/map/light/samples.h"

#include <algorithm>
#include <cmath>

namespace oblong::map {
namespace {

// Kept in a float, as engines keep it.
float texel_at(const FileTexAxis& axis, const Floats& point) {
    return static_cast<float>(dot(to_point(axis.direction), to_point(point)) + static_cast<double>(axis.offset));
}

Point nearest_on_segment(const Point& point, const Point& from, const Point& to) {
    const Point along = to - from;
    const double t = std::clamp(dot(point - from, along) / dot(along, along), 0.0, 1.0);
    return from + scaled(along, t);
}

// In order.
std::vector<Floats> face_corners(const BspFile& bsp, const FileFace& face) {
    std::vector<Floats> corners;
    for (int i = 0; i < face.edge_count; ++i) {
        const int edge = at(bsp.surf_edges, face.first_surf_edge + i);
        const auto& ends = at(bsp.edges, std::abs(edge));
        corners.push_back(at(bsp.vertices, ends[edge < 0 ? 1 : 0]));
    }
    return corners;
}

// Worked out from the numbers in the file, as a reader does.
LightGrid light_grid(const BspFile& bsp, const FileFace& face) {
    const auto corners = face_corners(bsp, face);
    const FileTexInfo& texinfo = at(bsp.texinfos, face.texinfo);
    LightGrid grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        float low = texel_at(texinfo.axes[axis], corners[0]), high = low;
        for (const auto& corner : corners) {
            low = std::min(low, texel_at(texinfo.axes[axis], corner));
            high = std::max(high, texel_at(texinfo.axes[axis], corner));
        }
        grid.first[axis] = static_cast<int>(std::floor(low / LightGrid::kStep));
        grid.count[axis] = static_cast<int>(std::ceil(high / LightGrid::kStep)) - grid.first[axis] + 1;
    }
    return grid;
}

}  // namespace

FaceSampler::FaceSampler(const BspFile& bsp, const FileFace& face, const Tracer& tracer)
    : tracer_(tracer), grid_(light_grid(bsp, face)) {
    const FilePlane& plane = at(bsp.planes, face.plane);
    const Point plane_normal = to_point(plane.normal);
    normal_ = face.is_back != 0 ? -plane_normal : plane_normal;
    for (const auto& corner : face_corners(bsp, face)) {
        corners_.push_back(to_point(corner) + scaled(normal_, kLift));
        centre_ = centre_ + corners_.back();
    }
    centre_ = scaled(centre_, 1.0 / static_cast<double>(corners_.size()));
    for (const Point& corner : corners_) radius_ = std::max(radius_, length(corner - centre_));

    // u = s . p + s0, v = t . p + t0, distance = n . p, solved for p by Cramer's rule.
    const FileTexInfo& texinfo = at(bsp.texinfos, face.texinfo);
    const Point s = to_point(texinfo.axes[0].direction), t = to_point(texinfo.axes[1].direction);
    const double determinant = dot(s, cross(t, plane_normal));
    const Point per_u = scaled(cross(t, plane_normal), 1 / determinant);
    const Point per_v = scaled(cross(plane_normal, s), 1 / determinant);
    const Point per_distance = scaled(cross(s, t), 1 / determinant);
    const double first_u = LightGrid::kStep * grid_.first[0] - static_cast<double>(texinfo.axes[0].offset);
    const double first_v = LightGrid::kStep * grid_.first[1] - static_cast<double>(texinfo.axes[1].offset);
    step_u_ = scaled(per_u, LightGrid::kStep);
    step_v_ = scaled(per_v, LightGrid::kStep);
    base_ = scaled(per_u, first_u) + scaled(per_v, first_v) +
            scaled(per_distance, static_cast<double>(plane.distance)) + scaled(normal_, kLift);
}

Point FaceSampler::point_at(double u, double v) const {
    const Point point = base_ + scaled(step_u_, u) + scaled(step_v_, v);
    const Point over_face = nearest_over_face(point);
    return tracer_.is_clear(over_face, point) ? point : over_face;
}

// Within the polygon the point itself; else on its nearest edge, and a little inward.
Point FaceSampler::nearest_over_face(const Point& point) const {
    Point nearest = point;
    double nearest_distance = -1;
    bool is_inside = true;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point& from = corners_[i];
        const Point& to = corners_[(i + 1) % corners_.size()];
        if (dot(normal_, cross(to - from, point - from)) > 0) is_inside = false;
        const Point candidate = nearest_on_segment(point, from, to);
        const double distance = length(candidate - point);
        if (nearest_distance >= 0 && distance >= nearest_distance) continue;
        nearest = candidate;
        nearest_distance = distance;
    }
    if (is_inside && nearest_distance >= kInset) return point;
    const Point inward = centre_ - nearest;
    const double size = length(inward);
    return size <= kInset ? centre_ : nearest + scaled(inward, kInset / size);
}

}  // namespace oblong::map
