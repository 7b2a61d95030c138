#include "tools/map/tree/mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "tools/map/source/brush.h"
#include "tools/map/tree/surfaces.h"
#include "tools/map/tree/tree.h"

namespace oblong::map {

namespace {

constexpr double kGrid = 4096;

double snapped(double value) {
    const double whole = std::round(value);
    if (std::abs(value - whole) < 1.0 / 512) return whole;
    return std::round(value * kGrid) / kGrid;
}

constexpr double kOnEdge = VertexPool::kWeldDistance;

// Edges are cut from the vertex of the lower index to that of the higher one, so that both faces cut them alike.
class EdgeCutter {
  public:
    explicit EdgeCutter(const VertexPool& pool) : pool_(pool) {}

    // Appends the edge's vertices from `from` to before `to`.
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
        const std::uint64_t edge = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
        const auto known = cuts_.find(edge);
        if (known != cuts_.end()) return known->second;
        Loop inner;
        const int middle = nearest_on_edge(low, high);
        if (middle >= 0) {
            append_cut(low, middle, inner);
            inner.erase(inner.begin());
            append_cut(middle, high, inner);
        }
        return cuts_[edge] = std::move(inner);
    }

    // The vertex nearest to the edge's line of those on the edge whose distance from either end is less than the edge's
    // length; of equally near ones, the first.
    int nearest_on_edge(int low, int high) {
        int nearest = -1;
        double nearest_distance = kOnEdge;
        find_candidates(pool_[low], pool_[high]);
        for (const int vertex : candidates_) {
            if (vertex == low || vertex == high) continue;
            const double distance = distance_from_edge(vertex, low, high);
            if (distance > nearest_distance || (distance == nearest_distance && vertex >= nearest)) continue;
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
        return length(from_low - edge * (along / size));
    }

    // Long edges are searched in pieces, since a slanted edge's box may contain much of the level.
    void find_candidates(const Point& from, const Point& to) {
        candidates_.clear();
        const int pieces = 1 + static_cast<int>(length(to - from) / 64);
        for (int i = 0; i < pieces; ++i) {
            Box box;
            box.add(from + (to - from) * (static_cast<double>(i) / pieces));
            box.add(from + (to - from) * (static_cast<double>(i + 1) / pieces));
            pool_.add_near(box.grown(kOnEdge), candidates_);
        }
    }

    const VertexPool& pool_;
    std::vector<int> candidates_;                   // some more than once
    std::unordered_map<std::uint64_t, Loop> cuts_;  // by both vertices
};

// Removes edges of length 0, and pairs of edges to a vertex and back.
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

constexpr double kMargin = 128;  // larger than the movers' boxes

struct Partition {
    Tree tree;
    Portals portals;
};

Partition partition_brushes(const std::vector<Brush>& brushes, const PlaneList& planes, const Box& outer) {
    Partition made;
    made.tree = build_tree(outline(brushes, planes), planes);
    made.portals = find_portals(made.tree, planes, outer);
    const BrushContents contents(brushes, planes);
    fill_leaves(made.tree, made.portals, [&](const Point& point) { return contents.at(point); });
    return made;
}

// The same partition into contents by a tree of only their boundaries: smaller, without the inside of solids and the
// outside of the level.
Partition refined(const Partition& rough, const PlaneList& planes, const Box& outer) {
    Partition made;
    made.tree = build_tree(boundaries(rough.tree, rough.portals), planes);
    made.portals = find_portals(made.tree, planes, outer);
    fill_leaves(made.tree, made.portals,
                [&](const Point& point) { return rough.tree.leaf(leaf_at(rough.tree, planes, point)).contents; });
    return made;
}

Tree make_hull(const std::vector<Brush>& grown, const PlaneList& planes, const Box& outer, const SealStarts& starts,
               bool is_draft) {
    Partition rough = partition_brushes(grown, planes, outer);
    if (starts) fill_outside(rough.tree, planes, rough.portals, *starts);
    return is_draft ? std::move(rough.tree) : refined(rough, planes, outer).tree;
}

Box box_of_brushes(const std::vector<Brush>& brushes) {
    Box box;
    for (const Brush& brush : brushes) box.add(brush.box);
    return box;
}

void make_mesh(CompiledModel& model) {
    for (const Surface& surface : model.surfaces) {
        Loop loop;
        for (const Point& point : surface.winding) loop.push_back(model.vertices.find_or_add(point));
        model.loops.push_back(std::move(loop));
    }
    fix_t_junctions(model.loops, model.vertices);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < model.loops.size(); ++i) {
        if (model.loops[i].empty()) continue;
        std::swap(model.loops[kept], model.loops[i]);
        std::swap(model.surfaces[kept], model.surfaces[i]);
        ++kept;
    }
    model.loops.resize(kept);
    model.surfaces.resize(kept);
}

}  // namespace

int VertexPool::find_or_add(const Point& point) {
    const Point wanted{snapped(point.x), snapped(point.y), snapped(point.z)};
    int nearest = -1;
    double nearest_distance = kWeldDistance;
    near_.clear();
    add_near(box_of(std::span(&wanted, 1)).grown(kWeldDistance), near_);
    for (const int index : near_) {
        const double distance = length((*this)[index] - wanted);
        if (distance > nearest_distance || (distance == nearest_distance && index >= nearest)) continue;
        nearest = index;
        nearest_distance = distance;
    }
    if (nearest >= 0) return nearest;
    points_.push_back(wanted);
    const int added = static_cast<int>(points_.size()) - 1;
    const Cell cell = cell_of(wanted);
    cells_[key_of(cell[0], cell[1], cell[2])].push_back(added);
    return added;
}

void VertexPool::add_near(const Box& box, std::vector<int>& found) const {
    const Cell low = cell_of(box.mins), high = cell_of(box.maxs);
    for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) {
                const auto cell = cells_.find(key_of(x, y, z));
                if (cell != cells_.end()) found.insert(found.end(), cell->second.begin(), cell->second.end());
            }
        }
    }
}

VertexPool::Cell VertexPool::cell_of(const Point& point) {
    const auto cell = [](double value) { return static_cast<int>(std::floor(value / kCell)); };
    return {cell(point.x), cell(point.y), cell(point.z)};
}

// Levels are far less than 2^21 cells wide.
std::uint64_t VertexPool::key_of(int x, int y, int z) {
    constexpr std::uint64_t kMask = (1 << 21) - 1;
    const auto bits = [](int cell) { return static_cast<std::uint64_t>(cell) & kMask; };
    return bits(x) << 42 | bits(y) << 21 | bits(z);
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

ModelCompiler::ModelCompiler(const std::vector<Brush>& brushes, PlaneList& planes, const std::vector<TexInfo>& texinfos,
                             SealStarts starts, bool is_draft)
    : brushes_(brushes), planes_(planes), texinfos_(texinfos), starts_(std::move(starts)), is_draft_(is_draft) {
    result_.model.box = box_of_brushes(brushes);
    grown_.push_back(hull_brushes(brushes, kPlayerBox, planes));
    if (!is_draft) grown_.push_back(hull_brushes(brushes, kLargeBox, planes));
    result_.model.hulls.resize(grown_.size());
}

void ModelCompiler::do_part(std::size_t part) {
    const Box outer = result_.model.box.grown(kMargin);
    if (part == 0) return make_drawn(outer);
    std::vector<Brush>& grown = grown_[part - 1];
    for (Brush& brush : grown) set_windings(brush, planes_);
    result_.model.hulls[part - 1] = make_hull(grown, planes_, outer, starts_, is_draft_);
}

void ModelCompiler::make_drawn(const Box& outer) {
    CompiledModel& model = result_.model;
    std::vector<Brush> seen = brushes_;
    std::erase_if(seen, [](const Brush& brush) { return brush.is_clip; });
    Partition rough = partition_brushes(seen, planes_, outer);
    if (starts_) {
        const Tree whole = is_draft_ ? rough.tree : Tree{};
        result_.leak = fill_outside(rough.tree, planes_, rough.portals, *starts_);
        if (is_draft_ && !has_inside(rough.tree)) rough.tree = whole;  // brushes that enclose nothing are shown
    }
    if (result_.leak && !is_draft_) return;
    Partition fine = refined(rough, planes_, outer);
    model.surfaces = subdivided(make_surfaces(fine.tree, planes_, fine.portals, seen), texinfos_);
    make_mesh(model);
    model.tree = std::move(fine.tree);
    model.portals = std::move(fine.portals);
}

}  // namespace oblong::map
