#include "tools/map/tree/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace oblong::map {
namespace {

constexpr double kGrid = 4096;

double snapped(double value) {
    const double whole = std::round(value);
    if (std::abs(value - whole) < 1.0 / 512) return whole;
    return std::round(value * kGrid) / kGrid;
}

constexpr double kOnEdge = VertexPool::kWeldDistance;

// Edges are cut from the vertex of the lower index to that of the higher one, so that both faces cut alike.
class EdgeCutter {
  public:
    explicit EdgeCutter(const VertexPool& pool) : pool_(pool) {}

    // The edge's vertices from `from` to before `to`.
    void append_cut(int from, int to, Loop& loop) {
        const Loop& inner = cut(std::min(from, to), std::max(from, to));
        loop.push_back(from);
        if (from < to) {
            loop.insert(loop.end(), inner.begin(), inner.end());
        } else {
            loop.insert(loop.end(), inner.rbegin(), inner.rend());
        }
    }

  private:
    const Loop& cut(int low, int high) {
        const auto known = cuts_.find({low, high});
        if (known != cuts_.end()) return known->second;
        Loop inner;
        const int middle = nearest_on_edge(low, high);
        if (middle >= 0) {
            append_cut(low, middle, inner);
            inner.erase(inner.begin());
            append_cut(middle, high, inner);
        }
        return cuts_[{low, high}] = std::move(inner);
    }

    // The vertex nearest to the edge's line among those on the edge and nearer to both ends than they to each other.
    int nearest_on_edge(int low, int high) const {
        int nearest = -1;
        double nearest_distance = kOnEdge;
        for (const int vertex : candidates(pool_[low], pool_[high])) {
            if (vertex == low || vertex == high) continue;
            const double distance = distance_from_edge(vertex, low, high);
            if (distance >= nearest_distance) continue;
            nearest = vertex;
            nearest_distance = distance;
        }
        return nearest;
    }

    // kOnEdge for vertices that are not within the edge.
    double distance_from_edge(int vertex, int low, int high) const {
        const Point edge = pool_[high] - pool_[low], from_low = pool_[vertex] - pool_[low];
        const double size = length(edge);
        const double along = dot(from_low, edge) / size;
        if (along <= 0 || along >= size) return kOnEdge;
        if (length(from_low) >= size || length(pool_[vertex] - pool_[high]) >= size) return kOnEdge;
        return length(from_low - scaled(edge, along / size));
    }

    // Long edges are searched in pieces: the box of a slanted one holds much of the level.
    std::vector<int> candidates(const Point& from, const Point& to) const {
        std::vector<int> found;
        const int pieces = 1 + static_cast<int>(length(to - from) / 64);
        for (int i = 0; i < pieces; ++i) {
            Box box;
            box.add(from + scaled(to - from, static_cast<double>(i) / pieces));
            box.add(from + scaled(to - from, static_cast<double>(i + 1) / pieces));
            const std::vector<int> some = pool_.near_box(box.grown(kOnEdge));
            found.insert(found.end(), some.begin(), some.end());
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    const VertexPool& pool_;
    std::map<std::pair<int, int>, Loop> cuts_;
};

// Removes edges of no length, and pairs that go to a vertex and straight back.
void remove_spikes(Loop& loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() >= 3;) {
        const std::size_t next = (i + 1) % loop.size(), after = (i + 2) % loop.size();
        if (loop[i] != loop[next] && loop[i] != loop[after]) {
            ++i;
            continue;
        }
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(next));
        i = 0;
    }
    if (loop.size() < 3) loop.clear();
}

}  // namespace

int VertexPool::find_or_add(const Point& point) {
    const Point wanted{snapped(point.x), snapped(point.y), snapped(point.z)};
    int nearest = -1;
    double nearest_distance = kWeldDistance;
    for (const int index : near_box(box_of(std::span(&wanted, 1)).grown(kWeldDistance))) {
        const double distance = length((*this)[index] - wanted);
        if (distance >= nearest_distance) continue;
        nearest = index;
        nearest_distance = distance;
    }
    if (nearest >= 0) return nearest;
    points_.push_back(wanted);
    const int added = static_cast<int>(points_.size()) - 1;
    cells_[cell_of(wanted)].push_back(added);
    return added;
}

std::vector<int> VertexPool::near_box(const Box& box) const {
    std::vector<int> found;
    const Cell low = cell_of(box.mins), high = cell_of(box.maxs);
    for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) {
                const auto cell = cells_.find({x, y, z});
                if (cell != cells_.end()) found.insert(found.end(), cell->second.begin(), cell->second.end());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

VertexPool::Cell VertexPool::cell_of(const Point& point) {
    const auto cell = [](double value) { return static_cast<int>(std::floor(value / kCell)); };
    return {cell(point.x), cell(point.y), cell(point.z)};
}

void fix_t_junctions(std::vector<Loop>& loops, const VertexPool& pool) {
    EdgeCutter cutter(pool);
    for (Loop& loop : loops) {
        Loop cut;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i], to = loop[(i + 1) % loop.size()];
            if (from != to) cutter.append_cut(from, to, cut);
        }
        remove_spikes(cut);
        loop = std::move(cut);
    }
}

}  // namespace oblong::map
