#include "tools/map/vis_flow.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "tools/map/separators.h"

namespace oblong::map {
namespace {

// Where many small clusters lie in the open, the chains of portals are too many to follow: so many steps are shared out
// among the portals, a few of which may use up to kShare times the mean of what is left.
constexpr long kAllSteps = 3000000;
constexpr long kShare = 8;

// One portal's flow through the level.
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
        pass_cluster(base_.cluster, base_.winding, {}, base_.might_see, 0);
        return steps_ < max_steps_ ? std::move(found_) : base_.might_see;
    }

    long steps() const { return steps_; }

  private:
    // `source`: what of the base portal is still looked from; `frustum`: planes that all that is seen is in front of.
    void pass_cluster(int cluster, const Winding& source, const std::vector<Plane>& frustum, const BitSet& might_see,
                      std::size_t depth) {
        for (const int index : graph_.portals_of_cluster[static_cast<std::size_t>(cluster)]) {
            const auto i = static_cast<std::size_t>(index);
            if (!might_see.has(i)) continue;
            const BitSet& beyond = is_done_[i] ? seen_[i] : graph_.portals[i].might_see;
            BitSet& next_might_see = scratch(depth);
            const bool has_news = next_might_see.set_common(might_see, beyond, found_);
            if (has_news || !found_.has(i)) pass_portal(i, source, frustum, next_might_see, depth);
        }
    }

    void pass_portal(std::size_t index, const Winding& source, const std::vector<Plane>& frustum,
                     const BitSet& might_see, std::size_t depth) {
        if (steps_ >= max_steps_) return;
        ++steps_;
        const VisPortal& portal = graph_.portals[index];
        Winding target = portal.winding;
        cut_to_front(target, base_.plane);
        for (const Plane& plane : frustum) {
            if (target.empty()) return;
            cut_to_front(target, plane);
        }
        Winding near_source = source;
        cut_to_front(near_source, portal.plane.flipped());
        if (target.empty() || near_source.empty()) return;
        found_.add(index);
        pass_cluster(portal.cluster, near_source, separators(near_source, target), might_see, depth + 1);
    }

    // A set for each level of the recursion; a deque, as references to them stay in use while it grows.
    BitSet& scratch(std::size_t depth) {
        while (scratch_.size() <= depth) scratch_.emplace_back(graph_.portals.size());
        return scratch_[depth];
    }

    const VisGraph& graph_;
    const std::vector<BitSet>& seen_;
    const std::vector<bool>& is_done_;
    const VisPortal& base_;
    const long max_steps_;
    BitSet found_;
    std::deque<BitSet> scratch_;
    long steps_ = 0;
};

// Those with little to see first: they help the others.
std::vector<std::size_t> by_might_see(const VisGraph& graph) {
    std::vector<int> counts;
    for (const VisPortal& portal : graph.portals) counts.push_back(portal.might_see.count());
    std::vector<std::size_t> order(graph.portals.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
    return order;
}

}  // namespace

std::vector<BitSet> find_seen_portals(const VisGraph& graph) {
    std::vector<BitSet> seen(graph.portals.size());
    std::vector<bool> is_done(graph.portals.size(), false);
    long steps_left = kAllSteps, portals_left = static_cast<long>(graph.portals.size());
    for (const std::size_t i : by_might_see(graph)) {
        Flow flow(graph, seen, is_done, graph.portals[i], std::max(steps_left, 0L) * kShare / portals_left);
        seen[i] = flow.run();
        is_done[i] = true;
        steps_left -= flow.steps();
        --portals_left;
    }
    return seen;
}

}  // namespace oblong::map
