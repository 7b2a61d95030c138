#include "engine/level/trace.h"

#include <algorithm>

#include "engine/fixed/wide.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Distances here have 40 fraction bits, not 42, so that the difference of two fits.
constexpr int kDroppedBits = 2;
constexpr std::int64_t kKeptApart_40 = std::int64_t{1} << 35;  ///< 1/32 unit
constexpr int kBackOffSteps = 10;

/// One of a model's trees, of nodes or of clipnodes. A child is a node if it is not negative.
class HullTree {
  public:
    HullTree(const Level& level, const SubModel& model, Hull hull)
        : level_(level), is_point_(hull == Hull::Point), root_(model.head_nodes[static_cast<std::size_t>(hull)]) {}

    std::int32_t root() const { return root_; }

    const LevelPlane& plane(std::int32_t node) const {
        const auto i = static_cast<std::size_t>(node);
        const std::int32_t plane = is_point_ ? level_.nodes[i].plane : level_.clip_nodes[i].plane;
        return level_.planes[static_cast<std::size_t>(plane)];
    }

    std::int32_t child(std::int32_t node, bool is_back) const {
        const auto i = static_cast<std::size_t>(node);
        return is_point_ ? level_.nodes[i].children[is_back] : level_.clip_nodes[i].children[is_back];
    }

    /// Of a child that is no node.
    std::int32_t contents(std::int32_t child) const {
        return is_point_ ? level_.leaves[static_cast<std::size_t>(-1 - child)].contents : child;
    }

    std::int32_t contents_at(std::int32_t child_or_root, Vec3<World> p) const {
        std::int32_t at = child_or_root;
        while (at >= 0) at = child(at, plane_side(plane(at), p) < 0);
        return contents(at);
    }

  private:
    const Level& level_;
    bool is_point_;
    std::int32_t root_;
};

/// A part of a line: numerator / denominator, from 0 to 1.
struct Part {
    std::int64_t numerator = 0, denominator = 1;
};

struct LinePoint {
    Vec3<World> p;
    Unit fraction;  ///< of the whole way
};

std::int64_t part_of(std::int64_t length, Part part) {
    return mul_div(length, part.numerator, part.denominator, Rounding::NearestHalfUp);
}

World point_between(World a, World b, Part part) {
    return World::from_raw(static_cast<std::int32_t>(a.raw + part_of(std::int64_t{b.raw} - a.raw, part)));
}

LinePoint point_between(const LinePoint& a, const LinePoint& b, Part part) {
    const Vec3<World> p = {point_between(a.p.x, b.p.x, part), point_between(a.p.y, b.p.y, part),
                           point_between(a.p.z, b.p.z, part)};
    const std::int64_t fraction = a.fraction.raw + part_of(std::int64_t{b.fraction.raw} - a.fraction.raw, part);
    return {p, Unit::from_raw(static_cast<std::int32_t>(fraction))};
}

std::int64_t distance_40(const LevelPlane& plane, Vec3<World> p) {
    const std::int64_t distance = floor_shift(plane_distance(plane, p), kDroppedBits).raw;
    return distance < 0 ? -distance : distance;
}

/// Where on the way from a to b, which lie on different sides, the plane is 1/32 unit ahead; 0 if it is nearer at a.
Part part_before(const LevelPlane& plane, Vec3<World> a, Vec3<World> b) {
    const std::int64_t near = distance_40(plane, a), far = distance_40(plane, b);
    if (near <= kKeptApart_40) return {0, 1};
    return {near - kKeptApart_40, near + far};
}

class HullTracer {
  public:
    HullTracer(const HullTree& tree, Vec3<World> from, Vec3<World> to) : tree_(tree) {
        start_ = {from, Unit::from_int(0)};
        result_.end = to;
        result_.is_all_solid = true;
    }

    TraceResult trace() {
        advance(tree_.root(), start_, {result_.end, Unit::from_int(1)});
        if (result_.is_all_solid) stop_at(start_);
        return result_;
    }

  private:
    /// Follows the line from a to b below a node; false if something stopped it.
    bool advance(std::int32_t node, const LinePoint& a, const LinePoint& b) {
        if (node < 0) return enter(tree_.contents(node));
        const LevelPlane& plane = tree_.plane(node);
        const bool is_back = plane_side(plane, a.p) < 0;
        const bool ends_back = plane_side(plane, b.p) < 0;
        if (is_back == ends_back) return advance(tree_.child(node, is_back), a, b);

        const Part part = part_before(plane, a.p, b.p);
        const LinePoint before = point_between(a, b, part);
        if (!advance(tree_.child(node, is_back), a, before)) return false;

        const std::int32_t beyond = tree_.child(node, !is_back);
        if (tree_.contents_at(beyond, before.p) != contents::kSolid) return advance(beyond, before, b);
        if (!result_.is_all_solid) hit(plane, is_back, a, b, part);
        return false;
    }

    bool enter(std::int32_t contents) {
        if (contents == contents::kSolid)
            result_.starts_solid = true;
        else
            result_.is_all_solid = false;
        return true;
    }

    void hit(const LevelPlane& plane, bool is_back, const LinePoint& a, const LinePoint& b, Part part) {
        result_.is_hit = true;
        result_.normal = is_back ? -plane.normal : plane.normal;
        stop_at(last_free_point(a, b, part));
    }

    void stop_at(const LinePoint& point) {
        result_.end = point.p;
        result_.fraction = point.fraction;
    }

    /// The point before the plane; where that is solid, as the last 1/32 unit before other planes was never looked at,
    /// the first that is not, back toward a in tenths of the way; at last the line's start.
    LinePoint last_free_point(const LinePoint& a, const LinePoint& b, Part part) const {
        const std::int64_t step = part.numerator / kBackOffSteps;
        for (int i = 0; i <= kBackOffSteps; ++i) {
            const LinePoint point = point_between(a, b, {part.numerator - i * step, part.denominator});
            if (tree_.contents_at(tree_.root(), point.p) != contents::kSolid) return point;
        }
        return start_;
    }

    const HullTree& tree_;
    LinePoint start_;
    TraceResult result_;
};

}  // namespace

std::int32_t hull_contents(const Level& level, const SubModel& model, Hull hull, Vec3<World> p) {
    const HullTree tree(level, model, hull);
    return tree.contents_at(tree.root(), p);
}

TraceResult trace_hull(const Level& level, const SubModel& model, Hull hull, Vec3<World> from, Vec3<World> to) {
    const HullTree tree(level, model, hull);
    return HullTracer(tree, from, to).trace();
}

}  // namespace oblong
