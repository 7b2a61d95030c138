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

// The vertex of the least distance that is less than `limit`; of equally near ones, the first. -1: there is none.
template <class DistanceOf>
int nearest_of(const std::vector<int>& vertices, double limit, DistanceOf distance_of) {
    int nearest = -1;
    for (const int vertex : vertices) {
        const double distance = distance_of(vertex);
        if (distance > limit || (distance == limit && vertex >= nearest)) continue;
        nearest = vertex;
        limit = distance;
    }
    return nearest;
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
        if (from < to)
            loop.insert(loop.end(), inner.begin(), inner.end());
        else
            loop.insert(loop.end(), inner.rbegin(), inner.rend());
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
        find_candidates(pool_[low], pool_[high]);
        return nearest_of(candidates_, kOnEdge, [&](int vertex) { return distance_from_edge(vertex, low, high); });
    }

    // kOnEdge for vertices that are not within the edge.
    double distance_from_edge(int vertex, int low, int high) const {
        if (vertex == low || vertex == high) return kOnEdge;
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

Partition partition_by(std::vector<BoundaryPiece> pieces, const PlaneList& planes, const Box& outer,
                       const std::function<int(const Point&)>& contents_of) {
    Partition made;
    made.tree = build_tree(std::move(pieces), planes);
    made.portals = find_portals(made.tree, planes, outer);
    fill_leaves(made.tree, made.portals, contents_of);
    return made;
}

Partition partition_brushes(const std::vector<Brush>& brushes, const PlaneList& planes, const Box& outer) {
    const BrushContents contents(brushes, planes);
    return partition_by(outline(brushes, planes), planes, outer,
                        [&](const Point& point) { return contents.at(point); });
}

// The same partition into contents by a tree of only their boundaries: smaller, without the inside of solids and the
// outside of the level.
Partition refined(const Partition& rough, const PlaneList& planes, const Box& outer) {
    return partition_by(boundaries(rough.tree, rough.portals), planes, outer, [&](const Point& point) {
        return rough.tree.leaf(leaf_at(rough.tree, planes, point)).contents;
    });
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

// Inserts into every edge the vertices on it (within the weld distance), so that no vertex is in the interior of an
// edge. Surfaces without area become empty; their neighbours have the same vertices, so that there is no gap.
void fix_t_junctions(std::vector<Surface>& surfaces, const VertexPool& pool) {
    EdgeCutter cutter(pool);
    for (Surface& surface : surfaces) {
        Loop cut;
        for (std::size_t i = 0; i < surface.loop.size(); ++i) {
            const int from = surface.loop[i], to = surface.loop[(i + 1) % surface.loop.size()];
            if (from != to) cutter.append_cut(from, to, cut);
        }
        remove_spikes(cut);
        surface.loop = std::move(cut);
    }
}

void make_mesh(CompiledModel& model) {
    for (Surface& surface : model.surfaces)
        for (const Point& point : surface.winding) surface.loop.push_back(model.vertices.find_or_add(point));
    fix_t_junctions(model.surfaces, model.vertices);
    std::erase_if(model.surfaces, [](const Surface& surface) { return surface.loop.empty(); });
}

}  // namespace

int VertexPool::find_or_add(const Point& point) {
    const Point wanted{snapped(point.x), snapped(point.y), snapped(point.z)};
    near_.clear();
    add_near(Box{wanted, wanted}.grown(kWeldDistance), near_);
    const int nearest = nearest_of(near_, kWeldDistance, [&](int index) { return length((*this)[index] - wanted); });
    if (nearest >= 0) return nearest;
    points_.push_back(wanted);
    const int added = static_cast<int>(points_.size()) - 1;
    const Cell cell = cell_of(wanted);
    cells_[key_of(cell[0], cell[1], cell[2])].push_back(added);
    return added;
}

void VertexPool::add_near(const Box& box, std::vector<int>& found) const {
    const Cell low = cell_of(box.mins), high = cell_of(box.maxs);
    for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int z = low[2]; z <= high[2]; ++z)
                if (const auto cell = cells_.find(key_of(x, y, z)); cell != cells_.end())
                    found.insert(found.end(), cell->second.begin(), cell->second.end());
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
