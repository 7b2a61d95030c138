#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tools/map/light/face_sampler.h"

namespace oblong::map {
namespace {

// A corner of a face.
struct FaceCorner {
    Point normal;
    double limit_degrees = 0, angle = 0;
    int group = 0;
};

double angle_between(const Point& a, const Point& b) {
    return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), -1.0, 1.0));
}

Point mean_normal(const FaceCorner& own, const std::vector<FaceCorner>& at_corner) {
    Point sum;
    for (const FaceCorner& other : at_corner) {
        const double limit = std::min(own.limit_degrees, other.limit_degrees) + 0.01;
        if (own.group == other.group && angle_between(own.normal, other.normal) * 180 / std::numbers::pi <= limit)
            sum = sum + other.normal * other.angle;
    }
    const double size = length(sum);
    return size > 0 ? sum * (1 / size) : own.normal;
}

constexpr double kStraight = std::numbers::pi - 1e-3;

// A corner within an edge, where only faces that are not smoothed have one, divides the edge: its normal lies between
// those of the edge's ends.
void interpolate_within_edges(const Winding& corners, const std::vector<bool>& is_within, std::vector<Point>& normals) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (!is_within[k]) continue;
        std::size_t first = k, last = k;
        while (is_within[first]) first = (first + corners.size() - 1) % corners.size();
        while (is_within[last]) last = (last + 1) % corners.size();
        const Point& from = corners[first];
        const double share = length(corners[k] - from) / length(corners[last] - from);
        normals[k] = normals[first] * (1 - share) + normals[last] * share;
    }
}

// Two faces share an edge's corners in opposite order.
void find_faces_across(const BspFile& bsp, std::vector<SmoothFace>& faces) {
    const auto each_edge = [&](auto use) {
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (std::size_t k = 0; k < faces[i].normals.size(); ++k)
                use(i, k, bsp.surf_edges[as_size(bsp.faces[i].first_surf_edge) + k]);
    };
    const auto normals_of = [&](std::size_t face, std::size_t k) {
        const std::vector<Point>& normals = faces[face].normals;
        return std::pair(normals[k], normals[(k + 1) % normals.size()]);
    };
    std::map<int, std::pair<std::size_t, std::size_t>> places;  // face and corner by edge
    each_edge([&](std::size_t face, std::size_t k, int edge) { places[edge] = {face, k}; });
    each_edge([&](std::size_t face, std::size_t k, int edge) {
        const auto found = places.find(-edge);
        int across = -1;
        if (found != places.end()) {
            const auto [other, its_k] = found->second;
            const auto [from, to] = normals_of(face, k);
            if (normals_of(other, its_k) == std::pair(to, from)) across = static_cast<int>(other);
        }
        faces[face].across.push_back(across);
    });
}

}  // namespace

std::vector<SmoothFace> smooth_faces(const BspFile& bsp, const std::vector<SurfaceLight>& surfaces) {
    std::map<Floats, std::vector<FaceCorner>> by_place;
    const auto each_corner = [&](auto use) {
        for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
            const FileFace& face = bsp.faces[i];
            if (static_cast<std::size_t>(face.texinfo) >= surfaces.size()) continue;
            const SurfaceLight& surface = item(surfaces, face.texinfo);
            if (surface.smooth_degrees <= 0) continue;
            const Winding corners = face_corners(bsp, face);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const Point &here = corners[k], &next = corners[(k + 1) % corners.size()],
                            &last = corners[(k + corners.size() - 1) % corners.size()];
                use(i, to_floats(here),
                    FaceCorner{face_normal(bsp, face), surface.smooth_degrees, angle_between(next - here, last - here),
                               surface.smooth_group});
            }
        }
    };
    std::vector<SmoothFace> faces(bsp.faces.size());
    std::vector<std::vector<bool>> is_within(bsp.faces.size());
    each_corner([&](std::size_t, const Floats& place, const FaceCorner& corner) { by_place[place].push_back(corner); });
    each_corner([&](std::size_t face, const Floats& place, const FaceCorner& corner) {
        faces[face].normals.push_back(mean_normal(corner, by_place[place]));
        is_within[face].push_back(by_place[place].size() == 1 && corner.angle > kStraight);
    });
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (!faces[i].normals.empty())
            interpolate_within_edges(face_corners(bsp, bsp.faces[i]), is_within[i], faces[i].normals);
    find_faces_across(bsp, faces);
    return faces;
}

}  // namespace oblong::map
