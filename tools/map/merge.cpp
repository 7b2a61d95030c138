#include "tools/map/merge.h"

#include <optional>

namespace oblong::map {
namespace {

// Corners nearer than this are the same; an angle that bends less is straight.
constexpr double kSameEpsilon = 1.0 / 512;

bool is_same(const Point& a, const Point& b) {
    return std::abs(a.x - b.x) < kSameEpsilon && std::abs(a.y - b.y) < kSameEpsilon &&
           std::abs(a.z - b.z) < kSameEpsilon;
}

const Point& at(const Winding& winding, std::size_t index) {
    return winding[index % winding.size()];
}

// How far the corner sticks out of the line from `before` to `after`; negative: inward, the polygon is not convex.
double bulge(const Point& before, const Point& corner, const Point& after, const Point& normal) {
    const double chord = length(after - before);
    if (chord == 0) return -1;
    return -dot(normal, cross(corner - before, after - corner)) / chord;
}

// The union if edge i of `a` is edge j of `b` the other way.
std::optional<Winding> joined_at(const Winding& a, std::size_t i, const Winding& b, std::size_t j,
                                 const Point& normal) {
    const double first_bulge = bulge(at(a, i + a.size() - 1), at(a, i), at(b, j + 2), normal);
    const double second_bulge = bulge(at(b, j + b.size() - 1), at(a, i + 1), at(a, i + 2), normal);
    if (first_bulge < -kOnEpsilon || second_bulge < -kOnEpsilon) return std::nullopt;
    Winding joined;
    if (second_bulge > kOnEpsilon) joined.push_back(at(a, i + 1));
    for (std::size_t k = 2; k < a.size(); ++k) joined.push_back(at(a, i + k));
    if (first_bulge > kOnEpsilon) joined.push_back(at(a, i));
    for (std::size_t k = 2; k < b.size(); ++k) joined.push_back(at(b, j + k));
    return joined;
}

std::optional<Winding> joined(const Winding& a, const Winding& b, const Point& normal) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (!is_same(at(a, i), at(b, j + 1)) || !is_same(at(a, i + 1), at(b, j))) continue;
            return joined_at(a, i, b, j, normal);
        }
    }
    return std::nullopt;
}

Point facing(const std::vector<Winding>& windings) {
    Point sum;
    for (const Winding& winding : windings) sum = sum + area_vector(winding);
    const double size = length(sum);
    return size == 0 ? Point{} : scaled(sum, -1 / size);
}

struct Boxed {
    Winding winding;
    Box box;
};

// Joins `piece` to what is done, and the union again, until nothing fits.
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

std::vector<Winding> merged(std::vector<Winding> windings) {
    const Point normal = facing(windings);
    std::vector<Boxed> done;
    for (Winding& winding : windings) add(done, std::move(winding), normal);
    std::vector<Winding> result;
    for (Boxed& boxed : done) result.push_back(std::move(boxed.winding));
    return result;
}

}  // namespace oblong::map
