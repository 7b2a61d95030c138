#include "tools/map/light/tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblong::map {
namespace {

std::array<double, 3> between(const std::array<double, 3>& from, const std::array<double, 3>& to, double share) {
    return {from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share,
            from[2] + (to[2] - from[2]) * share};
}

constexpr double kFar = 8192;

}  // namespace

std::array<Point, 2> tangents(const Point& normal) {
    const Point first = unit(cross(normal, axis_vector(std::abs(normal.z) < 0.7 ? 2 : 0)));
    return {first, cross(normal, first)};
}

Tracer::Tracer(const BspFile& bsp, const std::vector<int>& shadow_models) : root_(bsp.models.front().head_nodes[0]) {
    for (const int model : shadow_models) shadow_roots_.push_back(item(bsp.models, model).head_nodes[0]);
    for (const FileNode& node : bsp.nodes) {
        const FilePlane& plane = item(bsp.planes, node.plane);
        const Point normal = to_point(plane.normal);
        TraceNode& trace =
            nodes_.emplace_back(TraceNode{place_of(normal), static_cast<double>(plane.distance), node.children});
        for (int axis = 0; axis < 3; ++axis)
            if (normal == axis_vector(axis)) trace.axis = axis;
    }
    for (const FileLeaf& leaf : bsp.leaves) opaque_.push_back(is_opaque(leaf.contents) ? leaf.contents : 0);
}

int Tracer::leaf_at(const Point& point) const {
    const Place place = place_of(point);
    int child = root_;
    while (child >= 0) {
        const TraceNode& node = item(nodes_, child);
        child = node.children[node.height_of(place) < 0 ? 1 : 0];
    }
    return -1 - child;
}

RayHit Tracer::hit_below(int root, const Point& from, const Point& to, bool stops_at_sky) const {
    RayHit hit;
    find_hit(root, place_of(from), place_of(to), 0, 1, stops_at_sky, hit);
    return hit;
}

// `hit.node` is the node of the last crossed plane: if the space behind it is opaque, the ray ends on it.
bool Tracer::find_hit(int child, const Place& from, const Place& to, double from_share, double to_share,
                      bool stops_at_sky, RayHit& hit) const {
    while (child >= 0) {
        const TraceNode& node = item(nodes_, child);
        const double from_height = node.height_of(from);
        const double to_height = node.height_of(to);
        const std::size_t near = from_height < 0 ? 1 : 0, far = to_height < 0 ? 1 : 0;
        if (near != far) {
            const double part = from_height / (from_height - to_height);
            const double share = from_share + (to_share - from_share) * part;
            const Place at = between(from, to, part);
            if (find_hit(node.children[near], from, at, from_share, share, stops_at_sky, hit)) return true;
            hit.node = child;
            return find_hit(node.children[far], at, to, share, to_share, stops_at_sky, hit);
        }
        child = node.children[near];
    }
    const int met = item(opaque_, -1 - child);
    if (met == 0 || (met == contents::kSky && !stops_at_sky)) return false;
    hit.contents = met;
    hit.share = from_share;
    return true;
}

Hemisphere gather(const Point& point, const Point& normal, int rings, int pattern, double dirt_depth,
                  const Tracer& tracer, const AddLight& add_reflected) {
    const auto [right, up] = tangents(normal);
    const double shift = (pattern + 0.5) / kPatterns, turn = static_cast<double>(2 * pattern % kPatterns) / kPatterns;
    const double share = 1.0 / (rings * rings);
    Hemisphere seen;
    for (int ring = 0; ring < rings; ++ring) {
        const double sine_squared = (ring + shift) / rings;  // evenly spaced, for Lambert's law
        const double sine = std::sqrt(sine_squared), cosine = std::sqrt(1 - sine_squared);
        for (int i = 0; i < rings; ++i) {
            const double angle = 2 * std::numbers::pi * (i + turn + 0.5 * (ring % 2)) / rings;
            const Point direction = right * (sine * std::cos(angle)) + up * (sine * std::sin(angle)) + normal * cosine;
            const RayHit hit = tracer.hit(point, point + direction * kFar);
            if (hit.contents == contents::kSky) (direction.z >= 0 ? seen.sky_above : seen.sky_below) += share;
            if (hit.contents != contents::kSolid) continue;
            seen.shut += share * std::max(1 - hit.share * kFar / dirt_depth, 0.0);
            if (add_reflected) add_reflected(point + direction * (kFar * hit.share), hit, direction, share, seen.light);
        }
    }
    return seen;
}

}  // namespace oblong::map
