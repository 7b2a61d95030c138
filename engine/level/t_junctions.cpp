#include "engine/level/t_junctions.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "engine/base/table.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// A vertex within this distance of an edge's line counts as on it: 8 steps of World, 1/512 unit. Compilers' error is
/// 2e-5.
constexpr std::int64_t kTolerance_12 = 8;
/// Longer edges, 262,144 units along an axis, are ignored: the square of their length would not fit.
constexpr std::int64_t kLongest_12 = std::int64_t{1} << 30;
/// The limit of all tests of vertices and rows of cells, against hostile levels; further edges stay unchanged.
constexpr std::int64_t kMostLooks = std::int64_t{1} << 28;

using GridPoint = std::array<std::int32_t, 3>;  ///< units, 12 fraction bits

GridPoint point_of(const Level& level, VertexIndex vertex) {
    const Vec3<World>& p = level.vertices[vertex];
    return {p.x.raw, p.y.raw, p.z.raw};
}

std::int64_t dot(const GridPoint& a, const GridPoint& b) {
    return std::int64_t{a[0]} * b[0] + std::int64_t{a[1]} * b[1] + std::int64_t{a[2]} * b[2];
}

/// to - from >= 0.
std::uint32_t way_up(std::int32_t from, std::int32_t to) {
    return static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
}

/// The vertices used by faces, in a grid of cubic cells. An edge of a real level passes near eight vertices.
class VertexGrid {
  public:
    explicit VertexGrid(const Level& level) : level_(level) {
        find_used();
        choose_cells();
        sort_into_cells();
    }

    /// Calls look(vertex) for the vertices in a box, and others near it. Returns the number of rows and vertices
    /// visited.
    template <class Look>
    std::int64_t look_within(const GridPoint& low, const GridPoint& high, Look look) const {
        const Cell first = cell_of(low), last = cell_of(high);
        std::int64_t looks = 0;
        for (std::size_t z = first[2]; z <= last[2]; ++z)
            for (std::size_t y = first[1]; y <= last[1]; ++y) {
                const std::uint32_t begin = starts_[position_of({first[0], y, z})],
                                    end = starts_[position_of({last[0], y, z}) + 1];
                for (std::uint32_t i = begin; i < end; ++i) look(vertices_[i]);
                looks += 1 + (end - begin);
            }
        return looks;
    }

  private:
    using Cell = std::array<std::size_t, 3>;
    static constexpr std::size_t kMostCells = 16;  ///< per vertex

    void find_used() {
        Table<std::uint8_t, Vertex> is_used(level_.vertices.size());
        for (const SurfEdge edge : level_.surf_edges)
            is_used[level_.edges[edge.edge()].from] = is_used[level_.edges[edge.edge()].to] = true;
        for (const VertexIndex vertex : level_.vertices.indices())
            if (is_used[vertex]) vertices_.push_back(vertex);
    }

    void choose_cells() {
        if (vertices_.empty()) return;
        GridPoint high = low_ = point_of(level_, vertices_.front());
        for (const VertexIndex vertex : vertices_) {
            const GridPoint p = point_of(level_, vertex);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low_[axis] = std::min(low_[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
        do {  // starts with cells of 16 units
            ++shift_;
            for (std::size_t axis = 0; axis < 3; ++axis) counts_[axis] = (way_up(low_[axis], high[axis]) >> shift_) + 1;
        } while (cell_count() > kMostCells * vertices_.size());
    }

    void sort_into_cells() {
        starts_.resize(as_size(cell_count()) + 1);
        for (const VertexIndex vertex : vertices_) ++starts_[position_of(vertex)];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());  // the cells' ends, until they are filled
        std::vector<VertexIndex> sorted(vertices_.size());
        for (const VertexIndex vertex : vertices_) item(sorted, --starts_[position_of(vertex)]) = vertex;
        vertices_ = std::move(sorted);
    }

    /// The cell of a point, or the nearest cell.
    Cell cell_of(const GridPoint& p) const {
        Cell cell{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (p[axis] > low_[axis])
                cell[axis] = std::min<std::size_t>(way_up(low_[axis], p[axis]) >> shift_, counts_[axis] - 1);
        return cell;
    }
    std::uint64_t cell_count() const { return std::uint64_t{counts_[0]} * counts_[1] * counts_[2]; }
    std::size_t position_of(const Cell& cell) const { return (cell[2] * counts_[1] + cell[1]) * counts_[0] + cell[0]; }
    std::size_t position_of(VertexIndex vertex) const { return position_of(cell_of(point_of(level_, vertex))); }

    const Level& level_;
    GridPoint low_{};
    int shift_ = 15;  ///< a cell's size is 2^shift_
    Cell counts_{1, 1, 1};
    std::vector<std::uint32_t> starts_;  ///< of each cell's vertices, and the last one's end
    std::vector<VertexIndex> vertices_;  ///< by cell
};

/// Finds the vertices inside one edge.
class EdgeLine {
  public:
    EdgeLine(const GridPoint& from, const GridPoint& to) : from_(from) {
        constexpr std::int64_t kLeast = std::numeric_limits<std::int32_t>::min(),
                               kMost = std::numeric_limits<std::int32_t>::max();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::minmax(from[axis], to[axis]);
            if (way_up(low, high) > kLongest_12) is_too_long_ = true;
            along_[axis] = static_cast<std::int32_t>(way_up(from[axis], to[axis]));
            low_[axis] = static_cast<std::int32_t>(std::max(low - kTolerance_12, kLeast));
            high_[axis] = static_cast<std::int32_t>(std::min(high + kTolerance_12, kMost));
        }
        if (!is_too_long_) length_squared_ = dot(along_, along_);
    }

    bool is_too_long() const { return is_too_long_; }
    const GridPoint& low() const { return low_; }
    const GridPoint& high() const { return high_; }

    /// The position along the edge, as a part of length_squared_; -1 if the vertex is not inside it.
    std::int64_t part_of(const GridPoint& p) const {
        if (!is_in_box(p)) return -1;
        const GridPoint offset{p[0] - from_[0], p[1] - from_[1], p[2] - from_[2]};
        const std::int64_t part = dot(offset, along_);
        if (part <= 0 || part >= length_squared_ || dot(offset, offset) <= kTolerance_12 * kTolerance_12) return -1;
        GridPoint to_end{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t nearest = mul_div(along_[axis], part, length_squared_);
            if (offset[axis] - nearest > kTolerance_12 || nearest - offset[axis] > kTolerance_12) return -1;
            to_end[axis] = along_[axis] - offset[axis];
        }
        return dot(to_end, to_end) <= kTolerance_12 * kTolerance_12 ? -1 : part;
    }

  private:
    bool is_in_box(const GridPoint& p) const {
        return p[0] >= low_[0] && p[0] <= high_[0] && p[1] >= low_[1] && p[1] <= high_[1] && p[2] >= low_[2] &&
               p[2] <= high_[2];
    }

    GridPoint from_, along_{}, low_{}, high_{};
    bool is_too_long_ = false;
    std::int64_t length_squared_ = 0;
};

}  // namespace

std::vector<TJunction> find_t_junctions(const Level& level) {
    std::vector<TJunction> found;
    const VertexGrid grid(level);
    std::vector<std::pair<std::int64_t, VertexIndex>> inside;
    std::int64_t looks = 0;
    for (const EdgeIndex index : level.edges.indices()) {
        if (looks > kMostLooks) break;
        const Edge& edge = level.edges[index];
        const EdgeLine line(point_of(level, edge.from), point_of(level, edge.to));
        if (line.is_too_long()) continue;
        inside.clear();
        looks += grid.look_within(line.low(), line.high(), [&](VertexIndex vertex) {
            const std::int64_t part = line.part_of(point_of(level, vertex));
            if (part >= 0) inside.emplace_back(part, vertex);
        });
        std::sort(inside.begin(), inside.end());
        for (const auto& [part, vertex] : inside) found.push_back({index, vertex});
    }
    return found;
}

std::span<const TJunction> junctions_on(std::span<const TJunction> all, EdgeIndex edge) {
    const auto first = std::partition_point(all.begin(), all.end(), [&](const auto& each) { return each.edge < edge; });
    const auto end = std::partition_point(first, all.end(), [&](const auto& each) { return each.edge == edge; });
    return {first, end};
}

}  // namespace oblong
