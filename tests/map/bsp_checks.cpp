#include "tests/map/bsp_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <sstream>

#include "engine/level/level.h"
#include "tests/support/random.h"

namespace oblong::test {

using map::BspFile;
using map::FileFace;
using map::FilePlane;
using map::Point;
using map::to_point;

namespace {

const auto& at(const auto& items, int index) {
    return items.at(as_size(index));
}

double height(const FilePlane& plane, const Point& point) {
    return dot(to_point(plane.normal), point) - static_cast<double>(plane.distance);
}

// Where a tree ends at a point, below 0.
int end_at(const BspFile& bsp, const auto& nodes, int child, const Point& point) {
    while (child >= 0) {
        const auto& node = at(nodes, child);
        child = node.children[height(at(bsp.planes, node.plane), point) < 0 ? 1 : 0];
    }
    return child;
}

std::array<int, 2> ends_of(const BspFile& bsp, int surf_edge) {
    const auto edge = at(bsp.edges, std::abs(surf_edge));
    return surf_edge < 0 ? std::array{edge[1], edge[0]} : edge;
}

}  // namespace

std::vector<Point> corners_of(const BspFile& bsp, const FileFace& face) {
    std::vector<Point> corners;
    for (int i = 0; i < face.edge_count; ++i)
        corners.push_back(to_point(at(bsp.vertices, ends_of(bsp, at(bsp.surf_edges, face.first_surf_edge + i))[0])));
    return corners;
}

FacingPlane facing_plane(const BspFile& bsp, const FileFace& face) {
    const FilePlane& plane = at(bsp.planes, face.plane);
    const double sign = face.is_back != 0 ? -1 : 1;
    return {to_point(plane.normal) * sign, sign * static_cast<double>(plane.distance)};
}

int light_at(const BspFile& bsp, const FacingPlane& plane, const Point& place, std::size_t style) {
    for (const auto& face : bsp.faces) {
        const FacingPlane facing = facing_plane(bsp, face);
        if (length(facing.normal - plane.normal) > 1e-6 || std::abs(facing.distance - plane.distance) > 1e-6) continue;
        const auto& axes = at(bsp.texinfos, face.texinfo).axes;
        std::array<int, 2> low{99999, 99999}, high{-99999, -99999}, step{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto texel = [&](const Point& p) {
                return dot(to_point(axes[i].direction), p) + static_cast<double>(axes[i].offset);
            };
            for (const Point& corner : corners_of(bsp, face)) {
                low[i] = std::min(low[i], static_cast<int>(std::floor(texel(corner) / 16)));
                high[i] = std::max(high[i], static_cast<int>(std::ceil(texel(corner) / 16)));
            }
            step[i] = static_cast<int>(std::lround(texel(place) / 16)) - low[i];
        }
        const int width = high[0] - low[0] + 1, height = high[1] - low[1] + 1;
        if (step[0] < 0 || step[1] < 0 || step[0] >= width || step[1] >= height) continue;
        if (face.light_offset < 0 || face.styles.at(style) == 255) return 0;
        const auto offset = as_size(face.light_offset + width * step[1] + step[0]) + style * as_size(width * height);
        return static_cast<unsigned char>(bsp.lighting.at(offset));
    }
    return -1;
}

int leaf_at(const BspFile& bsp, const Point& point) {
    return -1 - end_at(bsp, bsp.nodes, bsp.models.front().head_nodes[0], point);
}

int contents_at(const BspFile& bsp, int model, int hull, const Point& point) {
    const int root = at(at(bsp.models, model).head_nodes, hull);
    if (hull != 0) return end_at(bsp, bsp.clip_nodes, root, point);
    return at(bsp.leaves, -1 - end_at(bsp, bsp.nodes, root, point)).contents;
}

int open_edges(const BspFile& bsp) {
    std::map<std::array<int, 2>, int> uses;
    const auto& world = bsp.models.front();
    for (int i = 0; i < world.face_count; ++i) {
        const FileFace& face = at(bsp.faces, world.first_face + i);
        for (int k = 0; k < face.edge_count; ++k) {
            const auto ends = ends_of(bsp, at(bsp.surf_edges, face.first_surf_edge + k));
            ++uses[ends];
            --uses[{ends[1], ends[0]}];
        }
    }
    int open = 0;
    for (const auto& [ends, count] : uses) open += count > 0 ? count : 0;
    return open;
}

std::vector<bool> visible_leaves(const BspFile& bsp, int leaf) {
    const int count = bsp.models.front().visible_leaf_count;
    std::vector<bool> seen(as_size(count) + 1, false);
    int offset = at(bsp.leaves, leaf).visibility_offset;
    for (int byte = 0; byte < (count + 7) / 8;) {
        const int value = static_cast<unsigned char>(bsp.visibility.at(as_size(offset++)));
        if (value == 0) {
            byte += static_cast<unsigned char>(bsp.visibility.at(as_size(offset++)));
            continue;
        }
        for (int bit = 0; bit < 8; ++bit) {
            if ((value >> bit & 1) != 0) seen.at(as_size(8 * byte + bit + 1)) = true;
        }
        ++byte;
    }
    return seen;
}

namespace {

constexpr double kTooNear = 1.0 / 64;  // of points: what is welded or rounded
constexpr double kFar = 100000;

struct Polygon {
    FacingPlane plane;
    std::vector<Point> corners;
    bool is_liquid = false;
};

struct Ray {
    Point from, direction;
    Point at(double distance) const { return from + direction * distance; }
};

// The stretch of a ray in one leaf, up to `end`.
struct Stretch {
    int leaf = 0;
    double end = 0;
};

class CheckedLevel {
  public:
    explicit CheckedLevel(const BspFile& bsp) : bsp_(bsp), marked_(bsp.leaves.size()) {
        const auto& world = bsp.models.front();
        for (int i = 0; i < world.face_count; ++i) {
            const auto& face = at(bsp.faces, i);
            const auto& texinfo = at(bsp.texinfos, face.texinfo);
            const bool is_liquid = at(bsp.textures, texinfo.texture)[0] == '*';
            polygons_.push_back({facing_plane(bsp, face), corners_of(bsp, face), is_liquid});
        }
        for (std::size_t leaf = 0; leaf < bsp.leaves.size(); ++leaf) {
            for (int i = 0; i < bsp.leaves[leaf].mark_face_count; ++i)
                marked_[leaf].push_back(at(bsp.mark_faces, bsp.leaves[leaf].first_mark_face + i));
        }
    }

    const BspFile& bsp() const { return bsp_; }

    bool is_blocking(int leaf) const {
        const int contents = at(bsp_.leaves, leaf).contents;
        return contents == contents::kSolid || contents == contents::kSky;
    }

    // The leaves along a ray until the first that blocks, that one included.
    std::vector<Stretch> walk(const Ray& ray) const {
        std::vector<Stretch> stretches;
        walk(bsp_.models.front().head_nodes[0], ray, 0, kFar, stretches);
        return stretches;
    }

    // The first distance at which the ray meets the front of a face that is no liquid's, and the face. `slack`: how far
    // beyond its edges a face still counts as met.
    std::pair<double, int> first_face(const Ray& ray, double slack) const {
        std::pair<double, int> first{kFar, -1};
        for (std::size_t i = 0; i < polygons_.size(); ++i) {
            const auto distance = meets(polygons_[i], ray, slack);
            if (distance && *distance < first.first) first = {*distance, static_cast<int>(i)};
        }
        return first;
    }

    bool is_marked_in(int face, const std::vector<bool>& leaves) const {
        for (std::size_t leaf = 1; leaf < leaves.size(); ++leaf) {
            if (leaves[leaf] && std::find(marked_[leaf].begin(), marked_[leaf].end(), face) != marked_[leaf].end())
                return true;
        }
        return false;
    }

  private:
    bool walk(int child, const Ray& ray, double begin, double end, std::vector<Stretch>& stretches) const {
        if (child < 0) {
            stretches.push_back({-1 - child, end});
            return is_blocking(-1 - child);
        }
        const auto& node = at(bsp_.nodes, child);
        const FacingPlane plane = facing_plane(bsp_, {node.plane, 0, 0, 0, 0, {}, -1});
        const double begin_height = dot(plane.normal, ray.at(begin)) - plane.distance;
        const double end_height = dot(plane.normal, ray.at(end)) - plane.distance;
        const std::size_t near = begin_height < 0 ? 1 : 0, far = end_height < 0 ? 1 : 0;
        if (near == far) return walk(node.children[near], ray, begin, end, stretches);
        const double middle = begin + (end - begin) * begin_height / (begin_height - end_height);
        return walk(node.children[near], ray, begin, middle, stretches) ||
               walk(node.children[far], ray, middle, end, stretches);
    }

    static std::optional<double> meets(const Polygon& polygon, const Ray& ray, double slack) {
        const double approach = -dot(polygon.plane.normal, ray.direction);
        if (polygon.is_liquid || approach <= 0) return std::nullopt;
        const double distance = (dot(polygon.plane.normal, ray.from) - polygon.plane.distance) / approach;
        if (distance < -kTooNear) return std::nullopt;
        const Point hit = ray.at(distance);
        for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
            const Point& from = polygon.corners[i];
            const Point edge = polygon.corners[(i + 1) % polygon.corners.size()] - from;
            if (dot(polygon.plane.normal, cross(edge, hit - from)) > slack * length(edge)) return std::nullopt;
        }
        return distance;
    }

    const BspFile& bsp_;
    std::vector<Polygon> polygons_;
    std::vector<std::vector<int>> marked_;
};

Point random_direction(std::mt19937& random) {
    while (true) {
        const auto part = [&] { return random_between(random, -1, 1); };
        const Point p{part(), part(), part()};
        if (length(p) > 0.1 && length(p) < 1) return p * (1 / length(p));
    }
}

// A point of a random leaf; nothing if the box of the leaf did not yield one.
std::optional<Point> random_open_point(const CheckedLevel& level, std::mt19937& random) {
    const auto count = static_cast<unsigned>(level.bsp().models.front().visible_leaf_count);
    const int index = 1 + static_cast<int>(random() % count);
    const auto& box = at(level.bsp().leaves, index).box;
    if (level.is_blocking(index)) return std::nullopt;
    for (int tries = 0; tries < 50; ++tries) {
        Point point;
        for (std::size_t i = 0; i < 3; ++i) point[i] = random_between(random, box.mins[i], box.maxs[i]);
        if (leaf_at(level.bsp(), point) == index) return point;
    }
    return std::nullopt;
}

std::string described(const char* fault, const Ray& ray, double distance) {
    std::ostringstream text;
    text.precision(10);
    text << fault << " from " << ray.from.x << ' ' << ray.from.y << ' ' << ray.from.z << " towards " << ray.direction.x
         << ' ' << ray.direction.y << ' ' << ray.direction.z << " at distance " << distance;
    return text.str();
}

// At a grazing angle the rounding of a corner shifts the meeting point along the ray.
double shift_at(const CheckedLevel& level, const Ray& ray, int face) {
    if (face < 0) return 0;
    const FacingPlane plane = facing_plane(level.bsp(), at(level.bsp().faces, face));
    return 0.02 + 2 * kTooNear / std::abs(dot(ray.direction, plane.normal));
}

std::string fault_of(const CheckedLevel& level, const Ray& ray) {
    const std::vector<Stretch> stretches = level.walk(ray);
    const double open_until = stretches.size() < 2 ? 0 : stretches[stretches.size() - 2].end;
    if (!level.is_blocking(stretches.back().leaf)) return described("the ray leaves the level", ray, kFar);
    const auto [distance, face] = level.first_face(ray, kTooNear);
    if (distance > open_until + shift_at(level, ray, face)) return described("hole", ray, open_until);
    const auto [sure_distance, sure_face] = level.first_face(ray, -kTooNear);
    if (sure_distance < open_until - shift_at(level, ray, sure_face))
        return described("a wall in the air", ray, sure_distance);
    const std::vector<bool> seen = visible_leaves(level.bsp(), stretches.front().leaf);
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
        const double begin = i == 0 ? 0 : stretches[i - 1].end;
        if (stretches[i].end - begin > kTooNear && !seen[as_size(stretches[i].leaf)])
            return described("a leaf in sight is not in the visible set", ray, begin);
    }
    return level.is_marked_in(face, seen) ? "" : described("the face is in no visible leaf", ray, distance);
}

}  // namespace

std::string first_fault_of_rays(const BspFile& bsp, int ray_count, unsigned seed) {
    const CheckedLevel level(bsp);
    std::mt19937 random(seed);
    for (int i = 0; i < ray_count; ++i) {
        const auto from = random_open_point(level, random);
        if (!from) continue;
        const std::string fault = fault_of(level, {*from, random_direction(random)});
        if (!fault.empty()) return fault;
    }
    return "";
}

}  // namespace oblong::test
