#include "engine/mesh/triangulate.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "engine/math/soft_float.h"

namespace oblong {

namespace {

/// A corner projected along an axis.
struct FlatCorner {
    World x, y;
    bool operator==(const FlatCorner&) const = default;
};

/// The sign of the turn at b from a to c: positive counter-clockwise.
int turn_of(const FlatCorner& a, const FlatCorner& b, const FlatCorner& c) {
    WideSum sum;
    sum.add_product(widening_difference(b.x, a.x), widening_difference(c.y, a.y));
    sum.add_product(-widening_difference(b.y, a.y), widening_difference(c.x, a.x));
    const std::int64_t area = sum.scaled(0).mantissa;
    return (area > 0) - (area < 0);
}

/// Twice the signed area.
SoftFloat flat_area_of(std::span<const FlatCorner> corners) {
    WideSum sum;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const FlatCorner &from = corners[i], &to = corners[(i + 1) % corners.size()];
        sum.add_product(from.x, to.y);
        sum.add_product(-convert<WorldWide>(from.y), convert<WorldWide>(to.x));
    }
    return sum.scaled(0);
}

/// Whether |a| < |b|.
bool is_smaller(const SoftFloat& a, const SoftFloat& b) {
    if (a.is_zero() || b.is_zero()) return !b.is_zero();
    if (a.exponent != b.exponent) return a.exponent < b.exponent;
    return std::abs(a.mantissa) < std::abs(b.mantissa);
}

std::vector<FlatCorner> seen_along(int axis, std::span<const Vec3<World>> corners) {
    std::vector<FlatCorner> flat;
    for (const Vec3<World>& p : corners)
        flat.push_back(axis == 0 ? FlatCorner{p.y, p.z} : axis == 1 ? FlatCorner{p.z, p.x} : FlatCorner{p.x, p.y});
    return flat;
}

/// The polygon projected along the axis that makes it largest, turned counter-clockwise.
std::vector<FlatCorner> flattened(std::span<const Vec3<World>> corners) {
    std::vector<FlatCorner> best;
    SoftFloat best_area;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<FlatCorner> flat = seen_along(axis, corners);
        const SoftFloat area = flat_area_of(flat);
        if (!best.empty() && !is_smaller(best_area, area)) continue;
        best = std::move(flat);
        best_area = area;
    }
    if (best_area.mantissa < 0)
        for (FlatCorner& corner : best) std::swap(corner.x, corner.y);
    return best;
}

/// Cuts ears off a polygon; `left_` are the corners that remain.
class EarCutter {
  public:
    explicit EarCutter(std::vector<FlatCorner> corners) : corners_(std::move(corners)) {
        for (std::uint32_t i = 0; i < corners_.size(); ++i) left_.push_back(i);
        known_.resize(corners_.size());
    }

    std::vector<CornerTriple> cut() {
        std::vector<CornerTriple> triangles;
        while (left_.size() >= 3) {
            const std::size_t at = find_ear();
            triangles.push_back({neighbour(at, left_.size() - 1), left_[at], neighbour(at, 1)});
            for (const std::uint32_t changed : {triangles.back()[0], triangles.back()[2]}) known_[changed] = {};
            known_[left_[at]].is_cut = true;
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        }
        return triangles;
    }

  private:
    std::uint32_t neighbour(std::size_t at, std::size_t steps) const { return left_[(at + steps) % left_.size()]; }

    int turn_at(std::size_t at) {
        std::optional<int>& turn = known_[left_[at]].turn;
        if (!turn)
            turn = turn_of(corners_[neighbour(at, left_.size() - 1)], corners_[left_[at]], corners_[neighbour(at, 1)]);
        return *turn;
    }

    /// An ear; if there is none, a corner without a turn (its triangle has no area), else the first.
    std::size_t find_ear() {
        for (std::size_t at = 0; at < left_.size(); ++at)
            if (turn_at(at) > 0 && !holds_a_corner(at)) return at;
        for (std::size_t at = 0; at < left_.size(); ++at)
            if (turn_at(at) == 0) return at;
        return 0;
    }

    /// Whether another corner lies in the triangle at `at` or on its sides.
    bool holds_a_corner(std::size_t at) {
        std::optional<std::uint32_t>& held = known_[left_[at]].held;
        if (held && !known_[*held].is_cut) return true;
        const FlatCorner &a = corners_[neighbour(at, left_.size() - 1)], &b = corners_[left_[at]],
                         &c = corners_[neighbour(at, 1)];
        const auto found = std::find_if(left_.begin(), left_.end(), [&](std::uint32_t other) {
            const FlatCorner& p = corners_[other];
            if (p == a || p == b || p == c) return false;
            return turn_of(a, b, p) >= 0 && turn_of(b, c, p) >= 0 && turn_of(c, a, p) >= 0;
        });
        held = found == left_.end() ? std::nullopt : std::optional(*found);
        return held.has_value();
    }

    /// What was found out of a corner with its neighbours: else, a polygon would take time with the cube of its
    /// corners.
    struct Known {
        std::optional<int> turn;
        std::optional<std::uint32_t> held;  ///< a corner in its triangle
        bool is_cut = false;
    };

    std::vector<FlatCorner> corners_;
    std::vector<std::uint32_t> left_;
    std::vector<Known> known_;
};

}  // namespace

std::vector<CornerTriple> triangulate_by_diagonals(std::span<const Vec3<World>> corners) {
    return EarCutter(flattened(corners)).cut();
}

}  // namespace oblong
