#include "engine/level/trace.h"

#include <vector>

#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Distances with 40 fraction bits instead of 42, so that the difference of two fits.
using NarrowDistance = Fixed<std::int64_t, 40>;
constexpr auto kKeptApart = NarrowDistance::from_raw(std::int64_t{1} << 35);  ///< 1/32 unit
constexpr int kBackOffSteps = 10;

/// A model's tree of nodes, for a point.
struct PointTree {
    const Level& level;
    NodeChild root;

    const Node& node(NodeChild child) const { return level.nodes[child.node()]; }
    std::int32_t contents(NodeChild leaf) const { return level.leaves[leaf.leaf()].contents; }
};

/// A model's tree of clipnodes, for a body.
struct BodyTree {
    const Level& level;
    ClipChild root;

    const ClipNode& node(ClipChild child) const { return level.clip_nodes[child.node()]; }
    std::int32_t contents(ClipChild leaf) const { return leaf.contents(); }
};

template <class Tree, class Child>
std::int32_t contents_at(const Tree& tree, Child at, Vec3<World> p) {
    while (!at.is_leaf()) {
        const auto& node = tree.node(at);
        at = node.children[plane_side(tree.level.planes[node.plane], p) < 0];
    }
    return tree.contents(at);
}

/// Calls ask(tree) with a model's tree for a hull.
template <class Ask>
auto ask_tree(const Level& level, const SubModel& model, Hull hull, Ask ask) {
    if (hull == Hull::Point) return ask(PointTree{level, model.root});
    return ask(BodyTree{level, model.clip_roots[hull == Hull::Player ? 0 : 1]});
}

/// A fraction of a line: numerator / denominator, from 0 to 1.
struct Part {
    NarrowDistance numerator, denominator = NarrowDistance::ulp();
};

struct LinePoint {
    Vec3<World> p;
    Unit fraction;  ///< of the whole line
};

LinePoint point_between(const LinePoint& a, const LinePoint& b, Part part) {
    return {between(a.p, b.p, part.numerator, part.denominator),
            between(a.fraction, b.fraction, part.numerator, part.denominator)};
}

NarrowDistance distance_of(const LevelPlane& plane, Vec3<World> p) {
    return absolute(convert<NarrowDistance>(plane_distance(plane, p), Rounding::Floor));
}

/// Where on the line from a to b, on different sides of the plane, the plane is 1/32 unit ahead; 0 if a is nearer to
/// it.
Part part_before(const LevelPlane& plane, Vec3<World> a, Vec3<World> b) {
    const NarrowDistance near = distance_of(plane, a), far = distance_of(plane, b);
    if (near <= kKeptApart) return {};
    return {near - kKeptApart, near + far};
}

template <class Tree>
class HullTracer {
  public:
    HullTracer(const Tree& tree, Vec3<World> from, Vec3<World> to) : tree_(tree) {
        start_ = {from, Unit::from_int(0)};
        result_.end = to;
        result_.is_all_solid = true;
    }

    TraceResult trace() {
        advance(tree_.root, start_, {result_.end, Unit::from_int(1)});
        if (result_.is_all_solid) stop_at(start_);
        return result_;
    }

  private:
    /// Follows the line from a to b below a node; false if something stopped it.
    template <class Child>
    bool advance(Child at, const LinePoint& a, const LinePoint& b) {
        if (at.is_leaf()) return enter(tree_.contents(at));
        const auto& node = tree_.node(at);
        const LevelPlane& plane = tree_.level.planes[node.plane];
        const bool is_back = plane_side(plane, a.p) < 0;
        const bool ends_back = plane_side(plane, b.p) < 0;
        if (is_back == ends_back) return advance(node.children[is_back], a, b);

        const Part part = part_before(plane, a.p, b.p);
        const LinePoint before = point_between(a, b, part);
        if (!advance(node.children[is_back], a, before)) return false;

        const Child beyond = node.children[!is_back];
        if (contents_at(tree_, beyond, before.p) != contents::kSolid) return advance(beyond, before, b);
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

    /// The point in front of the plane. If it is solid (the last 1/32 unit in front of other planes is never tested),
    /// the first free one toward a, in steps of a tenth of the distance; if there is none, the line's start.
    LinePoint last_free_point(const LinePoint& a, const LinePoint& b, Part part) const {
        const auto step = part.numerator / kBackOffSteps;
        for (int i = 0; i <= kBackOffSteps; ++i) {
            const LinePoint point = point_between(a, b, {part.numerator - step * i, part.denominator});
            if (contents_at(tree_, tree_.root, point.p) != contents::kSolid) return point;
        }
        return start_;
    }

    const Tree& tree_;
    LinePoint start_;
    TraceResult result_;
};

}  // namespace

std::int32_t hull_contents(const Level& level, const SubModel& model, Hull hull, Vec3<World> p) {
    return ask_tree(level, model, hull, [&](const auto& tree) { return contents_at(tree, tree.root, p); });
}

TraceResult trace_hull(const Level& level, const SubModel& model, Hull hull, Vec3<World> from, Vec3<World> to) {
    return ask_tree(level, model, hull, [&](const auto& tree) { return HullTracer(tree, from, to).trace(); });
}

namespace {

/// A pending part of the vertical line.
struct ColumnPart {
    NodeChild at;
    World high, low;
    PlaneIndex entered;  ///< the plane at its start; none: the line's start
};

World crossing(const LevelPlane& plane, const Vec3<World>& high, const Vec3<World>& low) {
    const PlaneDistance above = plane_distance(plane, high), below = plane_distance(plane, low);
    return between(high.z, low.z, above, above - below);
}

/// Cos 45 degrees.
constexpr Unit kLeastUp = Unit::from_raw(759250125);

bool is_floor(const Level& level, NodeChild leaf, PlaneIndex entered) {
    return level.leaves[leaf.leaf()].contents == contents::kSolid && !entered.is_none() &&
           absolute(level.planes[entered].normal.z) >= kLeastUp;
}

}  // namespace

std::optional<Floor> find_floor(const Level& level, const Vec3<World>& from, World most) {
    const auto at_height = [&from](World z) { return Vec3<World>{from.x, from.y, z}; };
    const World low = saturating_convert<World>(widening_difference(from.z, most));
    std::vector<ColumnPart> parts{{level.world().root, from.z, low, PlaneIndex::none()}};
    while (!parts.empty()) {
        ColumnPart part = parts.back();
        parts.pop_back();
        while (!part.at.is_leaf()) {
            const Node& node = level.nodes[part.at.node()];
            const LevelPlane& plane = level.planes[node.plane];
            const bool high_back = plane_side(plane, at_height(part.high)) < 0;
            const bool low_back = plane_side(plane, at_height(part.low)) < 0;
            part.at = node.children[high_back];
            if (high_back == low_back) continue;
            const World middle = crossing(plane, at_height(part.high), at_height(part.low));
            parts.push_back({node.children[low_back], middle, part.low, node.plane});
            part.low = middle;
        }
        const std::int32_t filling = level.leaves[part.at.leaf()].contents;
        if (is_floor(level, part.at, part.entered)) return Floor{part.entered, at_height(part.high)};
        if (filling == contents::kSolid || filling == contents::kSky) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace oblong
