#include <algorithm>
#include <deque>
#include <numeric>
#include <span>

#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

// Smaller heights are rounding errors.
constexpr double kNoHeight = 1e-8;

// A plane through an edge, with a normal of any length, and a point of the edge.
struct EdgePlane {
    Point normal, origin;
    double on_squared = 0;  // the square of the scaled height beyond which a point is off the plane

    EdgePlane(const Point& across, const Point& through)
        : normal(across), origin(through), on_squared(kOnEpsilon * kOnEpsilon * dot(across, across)) {}

    // The square of a scaled height, with the height's sign.
    double signed_square_of(const Point& point) const {
        const double height = dot(normal, point - origin);
        return height * std::abs(height);
    }
};

// Whether the winding is in front of the plane, and not completely on it. Checks the neighbours of `corner`, which is
// on the plane, first: if they are in front, all corners nearly always are.
bool is_in_front(const Winding& winding, std::size_t corner, const EdgePlane& plane) {
    const std::size_t last = winding.size() - 1;
    const double after = plane.signed_square_of(winding[corner == last ? 0 : corner + 1]);
    const double before = plane.signed_square_of(winding[corner == 0 ? last : corner - 1]);
    if (std::min(before, after) < -plane.on_squared) return false;
    double highest = 0, lowest = 0;
    for (const Point& point : winding) {
        const double square = plane.signed_square_of(point);
        highest = std::max(highest, square);
        lowest = std::min(lowest, square);
    }
    return lowest >= -plane.on_squared && highest > plane.on_squared;
}

// Appends the separators through an edge of `a`; they face `b`. All of `a` is on one side of such a plane: that of its
// middle. An edge in one of the existing planes needs none.
void add_separators_at_edges(const Winding& a, const Winding& b, std::vector<Plane>& planes) {
    const Point middle_of_a = middle(a);
    const auto there = static_cast<std::ptrdiff_t>(planes.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point& end = a[i + 1 == a.size() ? 0 : i + 1];
        if (std::any_of(planes.begin(), planes.begin() + there, [&](const Plane& plane) {
                return std::abs(plane.height_of(a[i])) < kNoHeight && std::abs(plane.height_of(end)) < kNoHeight;
            }))
            continue;
        const Point edge = end - a[i];
        const Point to_middle = middle_of_a - a[i];
        const std::size_t known = planes.size();
        for (std::size_t corner = 0; corner < b.size(); ++corner) {
            if (planes.size() > known && std::abs(planes.back().height_of(b[corner])) <= kOnEpsilon) continue;
            const Point across = cross(edge, b[corner] - a[i]);
            const double size_squared = dot(across, across);
            const double height_of_a = dot(across, to_middle);
            const EdgePlane plane(across * std::copysign(1.0, -height_of_a),
                                  a[i]);  // without a branch, as half of them are flipped
            if (size_squared < kOnEpsilon * kOnEpsilon || height_of_a * height_of_a <= plane.on_squared) continue;
            if (!is_in_front(b, corner, plane)) continue;
            const Point normal = plane.normal * (1 / std::sqrt(size_squared));
            planes.push_back({normal, dot(normal, a[i])});
        }
    }
}

bool reaches_into(const Winding& winding, const std::vector<Plane>& frustum) {
    return std::all_of(frustum.begin(), frustum.end(), [&](const Plane& plane) {
        return std::any_of(winding.begin(), winding.end(),
                           [&](const Point& point) { return plane.height_of(point) > kOnEpsilon; });
    });
}

BitSet narrowed(const VisGraph& graph, const VisPortal& base) {
    BitSet found(graph.portals.size());
    std::vector<Plane> frustum;
    for (const int index : item(graph.portals_of_cluster, base.cluster)) {
        const auto i = static_cast<std::size_t>(index);
        if (!base.might_see.has(i)) continue;
        const VisPortal& next = graph.portals[i];
        Winding source = base.winding, target = next.winding, spare;
        clip_to_front(target, base.plane, spare, false);
        clip_to_front(source, next.plane.flipped(), spare, false);
        if (source.empty() || target.empty()) continue;
        found.add(i);
        find_separators(source, target, frustum);
        flood_portals(graph, next.cluster, found, [&](std::size_t k) {
            return base.might_see.has(k) && next.might_see.has(k) && reaches_into(graph.portals[k].winding, frustum);
        });
    }
    return found;
}

// Many small clusters in open space have too many chains of portals to follow: the portals share kAllSteps steps, each
// of up to kShare times the mean of the remaining ones.
constexpr long kAllSteps = 20000000;
constexpr long kShare = 8;

// The number of portals followed at a time, from earlier results: independent of the number of threads, so that the
// sets are the same.
constexpr std::size_t kAtOnce = 12;

// The flow of one portal through the level.
class Flow {
  public:
    Flow(const VisGraph& graph, const std::vector<BitSet>& seen, const std::vector<bool>& is_done,
         const VisPortal& base, long max_steps)
        : graph_(graph),
          seen_(seen),
          is_done_(is_done),
          base_(base),
          max_steps_(max_steps),
          found_(graph.portals.size()) {}

    BitSet run() {
        Link& first = link(0);
        first.source = base_.winding;
        first.might_see.set(base_.might_see);
        pass_cluster(base_.cluster, 0);
        return steps_ < max_steps_ ? std::move(found_) : base_.might_see;
    }

    long steps() const { return steps_; }

  private:
    // A link of the current chain of portals; reused for the next chain, with its memory.
    struct Link {
        Winding source;              // the part of the base portal where lines of sight may start
        Winding target;              // the part of the last portal through which they may pass
        std::vector<Plane> frustum;  // all points visible beyond are in front of these
        ThinSet might_see;
    };

    // Continues from a cluster reached through `depth` portals after the base.
    void pass_cluster(int cluster, std::size_t depth) {
        Link& next = link(depth + 1);
        const Link& here = links_[depth];
        for (const int index : item(graph_.portals_of_cluster, cluster)) {
            const auto i = static_cast<std::size_t>(index);
            if (!here.might_see.has(i)) continue;
            const BitSet& beyond = is_done_[i] ? seen_[i] : graph_.portals[i].might_see;
            const bool has_news = next.might_see.set_common(here.might_see, beyond, found_);
            if (has_news || !found_.has(i)) pass_portal(i, depth, has_news);
        }
    }

    void pass_portal(std::size_t index, std::size_t depth, bool has_news) {
        if (steps_ >= max_steps_) return;
        ++steps_;
        const VisPortal& portal = graph_.portals[index];
        const Link& here = links_[depth];
        Link& next = links_[depth + 1];
        if (!find_target(portal, here.frustum, next.target)) return;
        next.source = here.source;
        cut_where_near(next.source, base_, portal.plane.flipped());
        if (next.source.empty()) return;
        found_.add(index);
        if (!has_news) return;
        find_separators(next.source, next.target, next.frustum);
        pass_cluster(portal.cluster, depth + 1);
    }

    // Sets `target` to the portal's part within the frustum; false: none.
    bool find_target(const VisPortal& portal, const std::vector<Plane>& frustum, Winding& target) {
        for (const Plane& plane : frustum)
            if (plane.height_of(portal.centre) <= -portal.radius) return false;
        target = portal.winding;
        cut_where_near(target, portal, base_.plane);
        for (const Plane& plane : frustum) {
            if (target.empty()) return false;
            cut_where_near(target, portal, plane);
        }
        return !target.empty();
    }

    // `part`: a part of the portal, which is completely in front of most planes.
    void cut_where_near(Winding& part, const VisPortal& portal, const Plane& plane) {
        if (plane.height_of(portal.centre) < portal.radius) clip_to_front(part, plane, spare_, false);
    }

    // In a deque, since references to links must stay valid while it grows.
    Link& link(std::size_t depth) {
        while (links_.size() <= depth) links_.push_back({{}, {}, {}, ThinSet(graph_.portals.size())});
        return links_[depth];
    }

    const VisGraph& graph_;
    const std::vector<BitSet>& seen_;
    const std::vector<bool>& is_done_;
    const VisPortal& base_;
    const long max_steps_;
    BitSet found_;
    Winding spare_;
    std::deque<Link> links_;
    long steps_ = 0;
};

// Visibility is symmetric: removes the reverse of each pair that is not visible (portal k ^ 1 is portal k in the other
// direction).
void forget_unseen(VisGraph& graph, std::size_t base, const BitSet& seen) {
    graph.portals[base].might_see.for_each_beyond(
        seen, [&](std::size_t k) { graph.portals[k ^ 1].might_see.remove(base ^ 1); });
}

// Portals with small sets first: their results speed up the others.
std::vector<std::size_t> by_might_see(const VisGraph& graph) {
    std::vector<int> counts;
    for (const VisPortal& portal : graph.portals) counts.push_back(portal.might_see.count());
    std::vector<std::size_t> order(graph.portals.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
    return order;
}

}  // namespace

void find_separators(const Winding& source, const Winding& pass, std::vector<Plane>& planes) {
    planes.clear();
    add_separators_at_edges(pass, source, planes);
    for (Plane& plane : planes) plane = plane.flipped();
    add_separators_at_edges(source, pass, planes);
}

void narrow_might_see(VisGraph& graph, const WorkSharing& sharing) {
    std::vector<BitSet> sets(graph.portals.size());
    sharing.for_each(sets.size(), [&](std::size_t i) { sets[i] = narrowed(graph, graph.portals[i]); });
    // Lines of sight run in both directions: portal i ^ 1 is portal i in the other direction.
    sharing.for_each(sets.size(), [&](std::size_t i) {
        BitSet& both = graph.portals[i].might_see = sets[i];
        sets[i].for_each([&](std::size_t k) {
            if (!sets[k ^ 1].has(i ^ 1)) both.remove(k);
        });
    });
}

std::vector<BitSet> find_seen_portals(VisGraph& graph, const WorkSharing& sharing) {
    std::vector<BitSet> seen(graph.portals.size());
    std::vector<bool> is_done(graph.portals.size(), false);
    const std::vector<std::size_t> order = by_might_see(graph);
    long steps_left = kAllSteps;
    for (std::size_t first = 0; first < order.size(); first += kAtOnce) {
        const std::span<const std::size_t> batch =
            std::span(order).subspan(first, std::min(kAtOnce, order.size() - first));
        const long most = std::max(steps_left, 0L) * kShare / static_cast<long>(order.size() - first);
        std::vector<long> steps(batch.size());
        sharing.for_each(batch.size(), [&](std::size_t i) {
            Flow flow(graph, seen, is_done, graph.portals[batch[i]], most);
            seen[batch[i]] = flow.run();
            steps[i] = flow.steps();
        });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            is_done[batch[i]] = true;
            forget_unseen(graph, batch[i], seen[batch[i]]);
            steps_left -= steps[i];
        }
    }
    return seen;
}

}  // namespace oblong::map
