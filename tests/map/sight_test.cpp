#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <random>

#include "tests/support/random.h"
#include "tools/map/vis/visibility.h"

namespace oblong::test::sight_test {
namespace {

using map::Point;
using map::VisGraph;

// A plan of rooms that are rectangles, cut from a square again and again, with openings between neighbours. Walls have
// no thickness, and all is 64 units high: what sees what is a matter of lines on the plan.
class Plan {
  public:
    explicit Plan(unsigned seed) : random_(seed) {
        cut({{0, 0}, {kSize, kSize}});
        graph_.portals_of_cluster.resize(rooms_.size());
        for (std::size_t a = 0; a < rooms_.size(); ++a)
            for (std::size_t b = 0; b < rooms_.size(); ++b)
                for (const int axis : {0, 1})
                    if (rooms_[a].high[axis] == rooms_[b].low[axis]) open_between(a, b, axis);
    }

    VisGraph& graph() { return graph_; }
    std::size_t portal_count() const { return openings_.size(); }

    // The portals that the line from the point `from` of portal `first` to `through` passes, `first` aside, until it
    // meets a wall or runs within kMargin of an opening's end.
    std::vector<std::size_t> passed(std::size_t first, const Point& from, const Point& through) const {
        std::vector<std::size_t> portals;
        const Point along = through - from;
        if (along[openings_[first].axis] * (first % 2 == 0 ? -1 : 1) <= 0) return portals;
        for (std::optional<std::size_t> at = first;; portals.push_back(*at)) {
            at = way_out(graph_.portals[*at].cluster, from, along);
            if (!at) return portals;
        }
    }

    // The point of the portal's opening that lies `inward` of its end 0 or 1.
    Point near_end(std::size_t portal, int end, double inward) const {
        const Opening& opening = openings_[portal];
        Point point;
        point[opening.axis] = opening.at;
        point[1 - opening.axis] = end == 0 ? opening.low + inward : opening.high - inward;
        return point;
    }

  private:
    static constexpr int kSize = 256, kLeast = 24;
    static constexpr double kMargin = 1.0 / 512;

    struct Room {
        std::array<int, 2> low, high;
    };
    struct Opening {
        int axis = 0, at = 0, low = 0, high = 0;  // across `axis`, where it is `at`
    };

    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

    void cut(const Room& room) {
        const int axis = below(2);
        const int free = room.high[axis] - room.low[axis] - 2 * kLeast;
        if (free <= 0) {
            rooms_.push_back(room);
            return;
        }
        const int at = room.low[axis] + kLeast + below(free);
        Room first = room, second = room;
        first.high[axis] = second.low[axis] = at;
        cut(first);
        cut(second);
    }

    // Nothing, all of the shared wall, or a slit in it.
    void open_between(std::size_t a, std::size_t b, int axis) {
        const int other = 1 - axis;
        int low = std::max(rooms_[a].low[other], rooms_[b].low[other]);
        int high = std::min(rooms_[a].high[other], rooms_[b].high[other]);
        const int kind = below(4);
        if (high - low < 4 || kind == 0) return;
        if (kind > 1) {
            low += below(high - low - 2);
            high = low + 2 + below(high - low - 1);
        }
        add_portals({axis, rooms_[a].high[axis], low, high}, static_cast<int>(a), static_cast<int>(b));
    }

    // As make_vis_graph() does: first that into the room in front of the plane's back.
    void add_portals(const Opening& opening, int back, int front) {
        const map::Plane plane{map::axis_vector(opening.axis), static_cast<double>(opening.at)};
        map::Winding winding;
        for (const auto& [end, z] : {std::pair{0, 0.0}, {0, 64.0}, {1, 64.0}, {1, 0.0}}) {
            Point& corner = winding.emplace_back();
            corner[opening.axis] = opening.at;
            corner[1 - opening.axis] = end == 0 ? opening.low : opening.high;
            corner.z = z;
        }
        const Point centre = map::middle(winding);
        const double radius = length(winding[0] - centre);
        const int index = static_cast<int>(graph_.portals.size());
        graph_.portals_of_cluster[static_cast<std::size_t>(front)].push_back(index);
        graph_.portals.push_back({winding, plane.flipped(), back, centre, radius, map::BitSet{}});
        graph_.portals_of_cluster[static_cast<std::size_t>(back)].push_back(index + 1);
        graph_.portals.push_back({winding, plane, front, centre, radius, map::BitSet{}});
        openings_.insert(openings_.end(), 2, opening);
    }

    // Where a line leaves a room that it is in: the portal there.
    std::optional<std::size_t> way_out(int cluster, const Point& from, const Point& along) const {
        const Room& room = rooms_[static_cast<std::size_t>(cluster)];
        int leaves_by = 0;
        std::array<double, 2> times{1e9, 1e9};
        for (const int axis : {0, 1}) {
            if (along[axis] != 0)
                times[axis] = ((along[axis] > 0 ? room.high : room.low)[axis] - from[axis]) / along[axis];
            if (times[axis] < times[leaves_by]) leaves_by = axis;
        }
        const Point at = from + along * times[leaves_by];
        for (const int index : graph_.portals_of_cluster[static_cast<std::size_t>(cluster)]) {
            const auto i = static_cast<std::size_t>(index);
            const Opening& opening = openings_[i];
            if (opening.axis != leaves_by || (i % 2 == 0) != (along[leaves_by] < 0)) continue;
            if (at[1 - leaves_by] > opening.low + kMargin && at[1 - leaves_by] < opening.high - kMargin) return i;
        }
        return std::nullopt;
    }

    std::mt19937 random_;
    std::vector<Room> rooms_;
    std::vector<Opening> openings_;  // of each portal
    VisGraph graph_;
};

// By portal, those that some line through two openings, near an end of each, passes afterwards: lines that pass most
// openings can be turned until they touch two ends.
std::vector<map::BitSet> seen_by_lines(const Plan& plan) {
    const std::size_t count = plan.portal_count();
    std::vector<map::BitSet> seen(count, map::BitSet(count));
    for (std::size_t first = 0; first < count; ++first)
        for (std::size_t other = 0; other < count; ++other)
            for (int ends = 0; ends < 4 && other / 2 != first / 2; ++ends)
                for (const std::size_t passed : plan.passed(first, plan.near_end(first, ends % 2, 1.0 / 256),
                                                            plan.near_end(other, ends / 2, 1.0 / 256)))
                    seen[first].add(passed);
    return seen;
}

// How many pairs `seen` has that `sets` lacks.
int lacking(const std::vector<map::BitSet>& seen, const std::vector<map::BitSet>& sets) {
    int count = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i].for_each_beyond(sets[i], [&](std::size_t) { ++count; });
    return count;
}

// Of what is seen beyond three openings or more, sets have a little too much: each is held against the first alone.
TEST(SightThroughPortals, IsThatOfLinesOnAPlan) {
    const map::WorkSharing alone(nullptr, nullptr);
    int pairs = 0, too_many = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        Plan plan(seed);
        const std::vector<map::BitSet> lines = seen_by_lines(plan);
        VisGraph& graph = plan.graph();
        map::find_might_see(graph, alone);
        for (int round = 0; round < 3; ++round) map::narrow_might_see(graph, alone);
        const std::vector<map::BitSet> sets = map::find_seen_portals(graph, alone);
        EXPECT_EQ(lacking(lines, sets), 0) << "hidden, in plan " << seed;
        for (const map::BitSet& of_portal : sets) pairs += of_portal.count();
        too_many += lacking(sets, lines);
    }
    EXPECT_GT(pairs, 50000);
    EXPECT_LT(too_many, pairs / 12);
}

using map::Plane, map::Point, map::Winding;

// A convex polygon in a plane of some z, or turned about the x axis; some have edges parallel to the axes.
Winding polygon(std::mt19937& random, double z) {
    const bool is_box = random_below(random, 2) == 0;
    const int corners = is_box ? 4 : 3 + random_below(random, 4);
    const double first = is_box ? 0.25 : random_between(random, 0, 1), size = random_between(random, 8, 64);
    const double slope = is_box ? 0 : random_between(random, -0.5, 0.5);
    const double x = 8 * random_below(random, 12), y = 8 * random_below(random, 12);
    Winding winding;
    for (int i = 0; i < corners; ++i) {
        const double angle = -2 * std::numbers::pi * (i + first) / corners - std::numbers::pi / 4;
        const double across = size * std::cos(angle), up = size * std::sin(angle);
        winding.push_back({x + across, y + up, z + slope * up});
    }
    return winding;
}

double least_height(const Winding& winding, const Plane& plane) {
    double least = 1e9;
    for (const Point& point : winding) least = std::min(least, plane.height_of(point));
    return least;
}

// By definition: of all planes through an edge of one and a corner of the other, facing either way, those with the
// source behind and the pass in front.
std::vector<Plane> all_separators(const Winding& source, const Winding& pass) {
    std::vector<Plane> found;
    const auto add = [&](const Winding& edges, const Winding& corners) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (const Point& corner : corners) {
                const Point normal = cross(edges[(i + 1) % edges.size()] - edges[i], corner - edges[i]);
                for (const double sign : {1.0, -1.0}) {
                    const Point unit = normal * (sign / length(normal));
                    const Plane plane{unit, dot(unit, edges[i])};
                    if (least_height(pass, plane) > -1e-6 && least_height(source, plane.flipped()) > -1e-6)
                        found.push_back(plane);
                }
            }
        }
    };
    add(source, pass);
    add(pass, source);
    return found;
}

double least_height(const std::vector<Plane>& planes, const Point& point) {
    double least = 1e9;
    for (const Plane& plane : planes) least = std::min(least, plane.height_of(point));
    return least;
}

TEST(Separators, BoundTheSameSpaceAsAllThatThereAre) {
    std::mt19937 random(9);
    std::vector<Plane> planes;
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Winding source = polygon(random, 0), pass = polygon(random, 128);
        const std::vector<Plane> expected = all_separators(source, pass);
        find_separators(source, pass, planes);
        ASSERT_GE(planes.size(), 3u) << trial;
        for (int i = 0; i < 200; ++i) {
            const Point point{random_between(random, -300, 400), random_between(random, -300, 400),
                              random_between(random, 200, 500)};
            const double height = least_height(expected, point);
            EXPECT_NEAR(least_height(planes, point), height, 0.01) << trial;
            ++(height > 0 ? inside : outside);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
}

TEST(Separators, EachIsThereOnce) {
    const Winding source{{0, 0, 0}, {0, 64, 0}, {64, 64, 0}, {64, 0, 0}};
    const Winding pass{{16, 16, 128}, {16, 32, 128}, {48, 32, 128}, {48, 16, 128}};
    std::vector<Plane> planes;
    find_separators(source, pass, planes);
    EXPECT_EQ(planes.size(), 4u);  // each through an edge of both
}

}  // namespace
}  // namespace oblong::test::sight_test
