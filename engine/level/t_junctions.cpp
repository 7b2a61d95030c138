#include "engine/level/t_junctions.h"

#include <algorithm>
#include <array>

#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// How far from an edge's line a vertex still counts as on it: 8 steps of World, 1/512 unit. Compilers leave 2e-5.
constexpr std::int64_t kTolerance_12 = 8;
/// Longer edges, 262,144 units along an axis, have no vertices inside: squares of their length would not fit.
constexpr std::int64_t kLongest_12 = std::int64_t{1} << 30;
/// Vertices tested in all, so that no hostile level takes too long; edges beyond that stay as they are.
constexpr std::int64_t kMostLooks = std::int64_t{1} << 28;

using Point = std::array<std::int64_t, 3>;  ///< units, 12 fraction bits

Point point_of(const Level& level, VertexIndex vertex) {
    return raw_of(level.vertices[vertex]);
}

std::int64_t dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Vertices in the order of one coordinate.
struct SortedAxis {
    std::vector<std::int64_t> values;
    std::vector<VertexIndex> vertices;
};

/// The vertices that faces use, ready to be looked up by place.
class VertexFinder {
  public:
    explicit VertexFinder(const Level& level) {
        UsedVertices is_used(level.vertices.size());
        for (const SurfEdge edge : level.surf_edges)
            is_used[level.edges[edge.edge].from] = is_used[level.edges[edge.edge].to] = true;
        for (std::size_t axis = 0; axis < 3; ++axis) sort_by(level, is_used, axis);
    }

    /// Calls look(vertex) for those within a box, and perhaps others; goes by the axis that leaves the fewest.
    template <class Look>
    void look_within(const Point& low, const Point& high, Look look) const {
        std::size_t best_first = 0, best_end = 0, best_axis = 3;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& values = axes_[axis].values;
            const auto first = std::lower_bound(values.begin(), values.end(), low[axis]) - values.begin();
            const auto end = std::upper_bound(values.begin(), values.end(), high[axis]) - values.begin();
            if (best_axis < 3 && static_cast<std::size_t>(end - first) >= best_end - best_first) continue;
            best_axis = axis;
            best_first = static_cast<std::size_t>(first);
            best_end = static_cast<std::size_t>(end);
        }
        for (std::size_t i = best_first; i < best_end; ++i) look(axes_[best_axis].vertices[i]);
    }

  private:
    using UsedVertices = Table<std::uint8_t, Vertex>;

    void sort_by(const Level& level, const UsedVertices& is_used, std::size_t axis) {
        SortedAxis& sorted = axes_[axis];
        for (const VertexIndex vertex : level.vertices.indices())
            if (is_used[vertex]) sorted.vertices.push_back(vertex);
        std::stable_sort(sorted.vertices.begin(), sorted.vertices.end(), [&](VertexIndex a, VertexIndex b) {
            return point_of(level, a)[axis] < point_of(level, b)[axis];
        });
        for (const VertexIndex vertex : sorted.vertices) sorted.values.push_back(point_of(level, vertex)[axis]);
    }

    std::array<SortedAxis, 3> axes_;
};

/// One edge, and which vertices lie inside it.
class EdgeLine {
  public:
    EdgeLine(const Point& from, const Point& to) : from_(from) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            along_[axis] = to[axis] - from[axis];
            low_[axis] = std::min(from[axis], to[axis]) - kTolerance_12;
            high_[axis] = std::max(from[axis], to[axis]) + kTolerance_12;
        }
        if (!is_too_long()) length_squared_ = dot(along_, along_);
    }

    bool is_too_long() const {
        return std::any_of(along_.begin(), along_.end(),
                           [](std::int64_t part) { return part > kLongest_12 || part < -kLongest_12; });
    }
    const Point& low() const { return low_; }
    const Point& high() const { return high_; }

    /// How far along the edge, as part of length_squared_; -1 if the vertex isn't inside it.
    std::int64_t part_of(const Point& p) const {
        Point offset{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (p[axis] < low_[axis] || p[axis] > high_[axis]) return -1;
            offset[axis] = p[axis] - from_[axis];
        }
        const std::int64_t part = dot(offset, along_);
        if (part <= 0 || part >= length_squared_ || dot(offset, offset) <= kTolerance_12 * kTolerance_12) return -1;
        Point to_end{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t nearest = mul_div(along_[axis], part, length_squared_);
            if (offset[axis] - nearest > kTolerance_12 || nearest - offset[axis] > kTolerance_12) return -1;
            to_end[axis] = along_[axis] - offset[axis];
        }
        return dot(to_end, to_end) <= kTolerance_12 * kTolerance_12 ? -1 : part;
    }

  private:
    Point from_, along_{}, low_{}, high_{};
    std::int64_t length_squared_ = 0;
};

}  // namespace

TJunctions::TJunctions(const Level& level) : found_(level.edges.size()) {
    const VertexFinder finder(level);
    std::vector<std::pair<std::int64_t, VertexIndex>> inside;
    std::int64_t looks = 0;
    for (const EdgeIndex index : level.edges.indices()) {
        if (looks > kMostLooks) return;
        const Edge& edge = level.edges[index];
        const EdgeLine line(point_of(level, edge.from), point_of(level, edge.to));
        if (line.is_too_long()) continue;
        inside.clear();
        finder.look_within(line.low(), line.high(), [&](VertexIndex vertex) {
            ++looks;
            const std::int64_t part = line.part_of(point_of(level, vertex));
            if (part >= 0) inside.emplace_back(part, vertex);
        });
        std::sort(inside.begin(), inside.end());
        found_[index] = {vertices_.size(), inside.size()};
        for (const auto& [part, vertex] : inside) vertices_.push_back(vertex);
    }
}

}  // namespace oblong
