#include "tools/map/light/face_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/text.h"

namespace oblong::map {
namespace {

// A float, as in engines.
float texel_at(const FileTexAxis& axis, const Point& point) {
    return static_cast<float>(dot(to_point(axis.direction), point) + static_cast<double>(axis.offset));
}

Point nearest_on_segment(const Point& point, const Point& from, const Point& to) {
    const Point along = to - from;
    const double t = std::clamp(dot(point - from, along) / dot(along, along), 0.0, 1.0);
    return from + along * t;
}

// The plane, facing and texinfo of a face, and the first and last vertex of one of its edges: unique to this face.
using EdgeKey = std::array<int, 5>;

std::vector<EdgeKey> edges_of(const BspFile& bsp, const FileFace& face) {
    const std::vector<int> corners = vertices_at(bsp, face);
    std::vector<EdgeKey> keys;
    for (std::size_t i = 0; i < corners.size(); ++i)
        keys.push_back({face.plane, face.is_back, face.texinfo, corners[i], corners[(i + 1) % corners.size()]});
    return keys;
}

}  // namespace

// Computed from the file's numbers, as by readers.
LightGrid light_grid(const BspFile& bsp, const FileFace& face) {
    const auto corners = face_corners(bsp, face);
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    LightGrid grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto [low, high] =
            range_of(corners, [&](const Point& corner) { return texel_at(texinfo.axes[axis], corner); });
        grid.first[axis] = static_cast<int>(std::floor(low / LightGrid::kStep));
        grid.count[axis] = static_cast<int>(std::ceil(high / LightGrid::kStep)) - grid.first[axis] + 1;
    }
    return grid;
}

Winding face_corners(const BspFile& bsp, const FileFace& face) {
    Winding corners;
    for (const int vertex : vertices_at(bsp, face)) corners.push_back(to_point(item(bsp.vertices, vertex)));
    return corners;
}

Point face_normal(const BspFile& bsp, const FileFace& face) {
    const Point normal = to_point(item(bsp.planes, face.plane).normal);
    return face.is_back != 0 ? -normal : normal;
}

FaceSampler::FaceSampler(const BspFile& bsp, const FileFace& face, SmoothFace smooth, const FaceSamplers& all,
                         const Tracer& tracer)
    : tracer_(tracer), all_(all), grid_(light_grid(bsp, face)), smooth_(std::move(smooth)) {
    const FilePlane& plane = item(bsp.planes, face.plane);
    const Point plane_normal = to_point(plane.normal);
    normal_ = face_normal(bsp, face);
    for (const Point& corner : face_corners(bsp, face)) corners_.push_back(corner + normal_ * kLift);
    centre_ = middle(corners_);
    for (const Point& corner : corners_) radius_ = std::max(radius_, length(corner - centre_));
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point along = corners_[(i + 1) % corners_.size()] - corners_[i];
        const Point outward = cross(normal_, along) * (1 / length(along));
        edges_.push_back({outward, dot(outward, corners_[i])});
    }

    // u = s . p + s0, v = t . p + t0, distance = n . p, solved for p with Cramer's rule.
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    const Point s = to_point(texinfo.axes[0].direction), t = to_point(texinfo.axes[1].direction);
    axes_ = {s, t};
    offsets_ = {static_cast<double>(texinfo.axes[0].offset), static_cast<double>(texinfo.axes[1].offset)};
    const double determinant = dot(s, cross(t, plane_normal));
    const Point per_u = cross(t, plane_normal) * (1 / determinant);
    const Point per_v = cross(plane_normal, s) * (1 / determinant);
    const Point per_distance = cross(s, t) * (1 / determinant);
    const double first_u = LightGrid::kStep * grid_.first[0] - static_cast<double>(texinfo.axes[0].offset);
    const double first_v = LightGrid::kStep * grid_.first[1] - static_cast<double>(texinfo.axes[1].offset);
    step_u_ = per_u * LightGrid::kStep;
    step_v_ = per_v * LightGrid::kStep;
    base_ = per_u * first_u + per_v * first_v + per_distance * static_cast<double>(plane.distance) + normal_ * kLift;
}

LitPoint FaceSampler::place_at(double u, double v) const {
    Point point = base_ + step_u_ * u + step_v_ * v;
    for (std::size_t i = 0; i < smooth_.across.size(); ++i) {
        if (smooth_.across[i] < 0 || edges_[i].height_of(point) <= 0) continue;
        const std::optional<FaceSampler>& next = item(all_, smooth_.across[i]);
        if (!next) continue;
        const Point beyond = point - next->normal_ * dot(next->normal_, point - next->centre_);
        if (next->sample_at(beyond)) return {beyond, next->normal_at(beyond)};
    }
    const Point over_face = nearest_over_face(point);
    if (over_face != point && !tracer_.is_clear(over_face, point)) point = over_face;
    return {point, normal_at(point)};
}

// Linear in each triangle between the middle and an edge.
Point FaceSampler::normal_at(const Point& point) const {
    if (smooth_.normals.empty()) return normal_;
    const Point middle_normal = middle(smooth_.normals);
    Point best = middle_normal;
    double most_inside = -1e9;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const std::size_t next = (i + 1) % corners_.size();
        const Point a = corners_[i] - centre_, b = corners_[next] - centre_, p = point - centre_;
        const double area = dot(normal_, cross(a, b));
        if (area == 0) continue;
        const double share_a = dot(normal_, cross(p, b)) / area, share_b = dot(normal_, cross(a, p)) / area;
        const double inside = std::min(share_a, share_b);
        if (inside <= most_inside) continue;
        most_inside = inside;
        const double sum_of_shares = std::max(share_a + share_b, 1.0);  // clamped to the edge
        best = smooth_.normals[i] * (std::max(share_a, 0.0) / sum_of_shares) +
               smooth_.normals[next] * (std::max(share_b, 0.0) / sum_of_shares) +
               middle_normal * (1 - std::clamp(share_a + share_b, 0.0, 1.0));
    }
    const double size = length(best);
    return size > 0 ? best * (1 / size) : normal_;
}

std::optional<std::size_t> FaceSampler::sample_at(const Point& point) const {
    if (std::any_of(edges_.begin(), edges_.end(), [&](const Plane& edge) { return edge.height_of(point) > kSlack; }))
        return std::nullopt;
    std::array<int, 2> place{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double texel = dot(axes_[axis], point) + offsets_[axis];
        place[axis] = std::clamp(static_cast<int>(std::lround(texel / LightGrid::kStep)) - grid_.first[axis], 0,
                                 grid_.count[axis] - 1);
    }
    return as_size(place[1] * grid_.count[0] + place[0]);
}

// The point itself if it is in the polygon; else slightly inward of the nearest point on its edges.
Point FaceSampler::nearest_over_face(const Point& point) const {
    if (std::all_of(edges_.begin(), edges_.end(),
                    [&](const Plane& edge) { return edge.height_of(point) < -kInset - kSlack; }))
        return point;
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
    return size <= kInset ? centre_ : nearest + inward * (kInset / size);
}

// The name at the beginning of a miptex: 16 bytes, the rest zero.
std::string texture_name(const BspFile& bsp, const FileFace& face) {
    const std::string& miptex = item(bsp.textures, item(bsp.texinfos, face.texinfo).texture);
    return lower_case(miptex.substr(0, std::min<std::size_t>(miptex.find('\0'), 16)));
}

std::vector<std::vector<int>> whole_surfaces(const BspFile& bsp, const std::function<bool(const FileFace&)>& is_meant) {
    std::vector<int> meant;
    std::map<EdgeKey, int> by_edge;
    for (int i = 0; i < static_cast<int>(bsp.faces.size()); ++i) {
        if (!is_meant(item(bsp.faces, i))) continue;
        meant.push_back(i);
        for (const EdgeKey& key : edges_of(bsp, item(bsp.faces, i))) by_edge.emplace(key, i);
    }
    std::set<int> known;
    std::vector<std::vector<int>> surfaces;
    for (const int first : meant) {
        if (!known.insert(first).second) continue;
        std::vector<int>& surface = surfaces.emplace_back(1, first);
        for (std::size_t next = 0; next < surface.size(); ++next) {
            for (EdgeKey key : edges_of(bsp, item(bsp.faces, surface[next]))) {
                std::swap(key[3], key[4]);  // the neighbour has it in the other direction
                const auto beyond = by_edge.find(key);
                if (beyond != by_edge.end() && known.insert(beyond->second).second) surface.push_back(beyond->second);
            }
        }
    }
    return surfaces;
}

}  // namespace oblong::map
