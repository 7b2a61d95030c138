#include "tools/map/source/geometry.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace oblong::map {

namespace {

// Ties (a normal at 45 degrees) yield the first axis, regardless of rounding.
int longest_axis(const Point& normal) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(normal[axis]) > std::abs(normal[longest]) + PlaneList::kNormalEpsilon) longest = axis;
    return longest;
}

Plane snapped(Plane plane) {
    const int axis = longest_axis(plane.normal);
    if (plane.normal[axis] < 1 - PlaneList::kNormalEpsilon * PlaneList::kNormalEpsilon) return plane;
    plane.normal = axis_vector(axis);
    const double whole = std::round(plane.distance);
    if (std::abs(plane.distance - whole) < PlaneList::kDistanceEpsilon) plane.distance = whole;
    return plane;
}

int type_of(const Plane& plane) {
    const int axis = longest_axis(plane.normal);
    return plane.normal[axis] == 1.0 ? axis : axis + 3;
}

bool is_same(const Plane& a, const Plane& b) {
    return std::abs(a.distance - b.distance) < PlaneList::kDistanceEpsilon &&
           largest_component(a.normal - b.normal) < PlaneList::kNormalEpsilon;
}

// The heights of a polygon's corners above a plane, on the stack except for large polygons.
class Heights {
  public:
    Heights(const Winding& winding, const Plane& plane) {
        if (winding.size() > few_.size()) {
            many_.resize(winding.size());
            heights_ = many_.data();
        }
        // Most planes lie along an axis.
        const double x = plane.normal.x, y = plane.normal.y, z = plane.normal.z;
        if (y == 0 && z == 0)
            measure(winding, [&](const Point& point) { return x * point.x - plane.distance; });
        else if (x == 0 && z == 0)
            measure(winding, [&](const Point& point) { return y * point.y - plane.distance; });
        else if (x == 0 && y == 0)
            measure(winding, [&](const Point& point) { return z * point.z - plane.distance; });
        else
            measure(winding, [&](const Point& point) { return plane.height_of(point); });
    }
    Heights(const Heights&) = delete;
    Heights& operator=(const Heights&) = delete;

    // 0: on the plane.
    double operator[](std::size_t i) const { return std::abs(heights_[i]) <= kOnEpsilon ? 0 : heights_[i]; }

    bool has_front = false, has_back = false;

  private:
    template <class HeightOf>
    void measure(const Winding& winding, HeightOf height_of) {
        double lowest = 0, highest = 0;
        for (std::size_t i = 0; i < winding.size(); ++i) {
            heights_[i] = height_of(winding[i]);
            lowest = std::min(lowest, heights_[i]);
            highest = std::max(highest, heights_[i]);
        }
        has_front = highest > kOnEpsilon;
        has_back = lowest < -kOnEpsilon;
    }

    std::array<double, 16> few_;
    std::vector<double> many_;
    double* heights_ = few_.data();
};

// Computed from the point in front to the one behind.
Point crossing(const Point& front, double front_height, const Point& back, double back_height, const Plane& plane) {
    Point at = front + (back - front) * (front_height / (front_height - back_height));
    const Point& normal = plane.normal;
    if (std::abs(normal.x) == 1.0) at.x = normal.x * plane.distance;
    if (std::abs(normal.y) == 1.0) at.y = normal.y * plane.distance;
    if (std::abs(normal.z) == 1.0) at.z = normal.z * plane.distance;
    return at;
}

// Calls add_front(point) and add_back(point) for the corners of the parts on either side.
template <class AddFront, class AddBack>
void cut(const Winding& winding, const Plane& plane, const Heights& heights, AddFront add_front, AddBack add_back) {
    double there = heights[0];
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const std::size_t next = i + 1 == winding.size() ? 0 : i + 1;
        const double here = std::exchange(there, heights[next]);
        if (here >= 0) add_front(winding[i]);
        if (here <= 0) add_back(winding[i]);
        if (here * there >= 0) continue;
        const Point at = here > 0 ? crossing(winding[i], here, winding[next], there, plane)
                                  : crossing(winding[next], there, winding[i], here, plane);
        add_front(at);
        add_back(at);
    }
}

// Corners nearer than this are the same; corners that protrude less are straight.
constexpr double kSameEpsilon = 1.0 / 512;

bool is_same(const Point& a, const Point& b) {
    return largest_component(a - b) < kSameEpsilon;
}

const Point& corner_at(const Winding& winding, std::size_t index) {
    return winding[index % winding.size()];
}

// The distance of the corner outside the line from `before` to `after`; negative: inside, so the polygon is not convex.
double bulge(const Point& before, const Point& corner, const Point& after, const Point& normal) {
    const double chord = length(after - before);
    if (chord == 0) return -1;
    return -dot(normal, cross(corner - before, after - corner)) / chord;
}

// The union, if edge i of `a` is the reversed edge j of `b`.
std::optional<Winding> joined_at(const Winding& a, std::size_t i, const Winding& b, std::size_t j,
                                 const Point& normal) {
    const double first_bulge = bulge(corner_at(a, i + a.size() - 1), corner_at(a, i), corner_at(b, j + 2), normal);
    const double second_bulge = bulge(corner_at(b, j + b.size() - 1), corner_at(a, i + 1), corner_at(a, i + 2), normal);
    if (first_bulge < -kOnEpsilon || second_bulge < -kOnEpsilon) return std::nullopt;
    Winding joined;
    if (second_bulge > kOnEpsilon) joined.push_back(corner_at(a, i + 1));
    for (std::size_t k = 2; k < a.size(); ++k) joined.push_back(corner_at(a, i + k));
    if (first_bulge > kOnEpsilon) joined.push_back(corner_at(a, i));
    for (std::size_t k = 2; k < b.size(); ++k) joined.push_back(corner_at(b, j + k));
    return joined;
}

std::optional<Winding> joined(const Winding& a, const Winding& b, const Point& normal) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (is_same(corner_at(a, i), corner_at(b, j + 1)) && is_same(corner_at(a, i + 1), corner_at(b, j)))
                return joined_at(a, i, b, j, normal);
    return std::nullopt;
}

Point facing(const std::vector<Winding>& windings) {
    Point sum;
    for (const Winding& winding : windings) sum = sum + area_vector(winding);
    return -unit(sum);
}

struct Boxed {
    Winding winding;
    Box box;
};

// Joins `piece` with a polygon in `done`, then the union with the others, until none fits.
void add(std::vector<Boxed>& done, Winding piece, const Point& normal) {
    Box box = box_of(piece);
    for (std::size_t i = done.size(); i-- > 0;) {
        if (!done[i].box.touches(box, kSameEpsilon)) continue;
        std::optional<Winding> both = joined(done[i].winding, piece, normal);
        if (!both) continue;
        piece = std::move(*both);
        box = box_of(piece);
        done.erase(done.begin() + static_cast<std::ptrdiff_t>(i));
        i = done.size();
    }
    done.push_back({std::move(piece), box});
}

}  // namespace

std::string point_text(const Point& point) {
    char text[64];
    std::snprintf(text, sizeof text, "%.6g %.6g %.6g", point.x, point.y, point.z);
    return text;
}

PlaneSide PlaneList::find_or_add(const Plane& plane) {
    const bool is_back = plane.normal[longest_axis(plane.normal)] < 0;
    const Plane wanted = snapped(is_back ? plane.flipped() : plane);
    const long bucket = std::lround(wanted.distance);
    for (const long near : {bucket - 1, bucket, bucket + 1}) {
        const auto found = by_distance_.find(near);
        if (found == by_distance_.end()) continue;
        for (const int index : found->second)
            if (is_same((*this)[index], wanted)) return {index, is_back};
    }
    planes_.push_back(wanted);
    types_.push_back(type_of(wanted));
    by_distance_[bucket].push_back(count() - 1);
    return {count() - 1, is_back};
}

Winding whole_plane(const Plane& plane) {
    const Point rough_up = axis_vector(longest_axis(plane.normal) == 2 ? 0 : 2);
    Point up = rough_up - plane.normal * dot(rough_up, plane.normal);
    up = up * (kHuge / length(up));
    const Point right = cross(up, plane.normal);
    const Point centre = plane.normal * plane.distance;
    return {centre - right + up, centre + right + up, centre + right - up, centre - right - up};
}

SplitWinding split(Winding winding, const Plane& plane) {
    const Heights heights(winding, plane);
    if (!heights.has_back) return {std::move(winding), {}, !heights.has_front};
    if (!heights.has_front) return {{}, std::move(winding), false};
    SplitWinding parts;
    parts.front.reserve(winding.size() + 1);
    parts.back.reserve(winding.size() + 1);
    cut(
        winding, plane, heights, [&](const Point& point) { parts.front.push_back(point); },
        [&](const Point& point) { parts.back.push_back(point); });
    return parts;
}

void clip_to_front(Winding& winding, const Plane& plane, Winding& spare, bool keeps_on) {
    const Heights heights(winding, plane);
    if (!heights.has_back && (heights.has_front || keeps_on)) return;
    spare.clear();
    spare.reserve(winding.size() + 1);
    if (heights.has_front)
        cut(
            winding, plane, heights, [&](const Point& point) { spare.push_back(point); }, [](const Point&) {});
    std::swap(winding, spare);
}

Reach reach(const Winding& winding, const Plane& plane) {
    Reach result;
    for (const Point& point : winding) {
        const double height = plane.height_of(point);
        result.front = std::max(result.front, height);
        result.back = std::max(result.back, -height);
    }
    return result;
}

Winding reversed(const Winding& winding) {
    return {winding.rbegin(), winding.rend()};
}

Point area_vector(const Winding& winding) {
    Point sum;
    for (std::size_t i = 2; i < winding.size(); ++i)
        sum = sum + cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
    return sum;
}

double least_width(const Winding& winding) {
    double least = 2 * kHuge;
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const Point edge = winding[(i + 1) % winding.size()] - winding[i];
        const double size = length(edge);
        if (size <= kOnEpsilon) continue;
        double farthest = 0;
        for (const Point& point : winding)
            farthest = std::max(farthest, length(cross(edge, point - winding[i])) / size);
        least = std::min(least, farthest);
    }
    return least;
}

Point middle(const Winding& winding) {
    Point sum;
    for (const Point& point : winding) sum = sum + point;
    return sum * (1.0 / static_cast<double>(winding.size()));
}

std::vector<Winding> merged(std::vector<Winding> windings) {
    const Point normal = facing(windings);
    std::vector<Boxed> done;
    for (Winding& winding : windings) add(done, std::move(winding), normal);
    std::vector<Winding> result;
    for (Boxed& boxed : done) result.push_back(std::move(boxed.winding));
    return result;
}

}  // namespace oblong::map
