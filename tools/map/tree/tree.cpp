#include "tools/map/tree/tree.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace oblong::map {
namespace {

// Whether the part of `side` (of `own`) within `other` is hidden by it.
bool hides(const Brush& other, bool is_other_later, const Brush& own, const BrushSide& side) {
    const int other_rank = contents_rank(other.contents), own_rank = contents_rank(own.contents);
    if (other_rank != own_rank) return other_rank > own_rank;
    return !other.has_side(side.plane) || is_other_later;
}

// For each brush, the others that touch it, in order.
std::vector<std::vector<std::size_t>> touching_brushes(const std::vector<Brush>& brushes) {
    std::vector<std::size_t> by_low(brushes.size());
    std::iota(by_low.begin(), by_low.end(), std::size_t{0});
    std::stable_sort(by_low.begin(), by_low.end(),
                     [&](std::size_t a, std::size_t b) { return brushes[a].box.mins.x < brushes[b].box.mins.x; });
    std::vector<std::vector<std::size_t>> touching(brushes.size());
    for (std::size_t i = 0; i < by_low.size(); ++i) {
        const Box& box = brushes[by_low[i]].box;
        for (std::size_t k = i + 1; k < by_low.size(); ++k) {
            if (brushes[by_low[k]].box.mins.x > box.maxs.x + kOnEpsilon) break;
            if (!brushes[by_low[k]].box.touches(box, kOnEpsilon)) continue;
            touching[by_low[i]].push_back(by_low[k]);
            touching[by_low[k]].push_back(by_low[i]);
        }
    }
    for (std::vector<std::size_t>& others : touching) std::sort(others.begin(), others.end());
    return touching;
}

// Whether the winding is outside of the box, or touches it from outside.
bool is_beside(const Box& winding, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const double over = winding.mins[axis] - box.maxs[axis], under = box.mins[axis] - winding.maxs[axis];
        if (std::max(over, under) > kOnEpsilon) return true;
        if (over >= -kOnEpsilon && winding.maxs[axis] > box.maxs[axis] + kOnEpsilon) return true;
        if (under >= -kOnEpsilon && winding.mins[axis] < box.mins[axis] - kOnEpsilon) return true;
    }
    return false;
}

// The same for the brush: the winding is completely on or in front of one of its sides, and partly in front.
bool is_beside(const Winding& winding, const Brush& brush, const PlaneList& planes) {
    return is_beside(box_of(winding), brush.box) ||
           std::any_of(brush.sides.begin(), brush.sides.end(), [&](const BrushSide& side) {
               if (planes.type(side.plane.plane) < 3) return false;  // a side of the box
               const Reach far = reach(winding, planes.facing(side.plane));
               return far.front > kOnEpsilon && far.back <= kOnEpsilon;
           });
}

// `winding` without its part inside `brush` or on its surface, in convex pieces; if nothing is inside, `winding`
// itself.
std::vector<Winding> outside_of(const Winding& winding, const Brush& brush, const PlaneList& planes) {
    std::vector<Winding> outside;
    Winding inside = winding;
    for (const BrushSide& side : brush.sides) {
        SplitWinding parts = split(std::move(inside), planes.facing(side.plane));
        if (parts.is_on) {
            inside = std::move(parts.front);
            continue;
        }
        if (!parts.front.empty()) outside.push_back(std::move(parts.front));
        inside = std::move(parts.back);
        if (inside.empty()) return {winding};
    }
    return outside;
}

std::vector<Winding> visible_part(const std::vector<Brush>& brushes, std::size_t own, const BrushSide& side,
                                  const std::vector<std::size_t>& touching, const PlaneList& planes) {
    std::vector<Winding> pieces{side.winding};
    const Box box = box_of(side.winding);
    for (const std::size_t other : touching) {
        if (pieces.empty()) break;
        if (!brushes[other].box.touches(box, kOnEpsilon)) continue;
        if (!hides(brushes[other], other > own, brushes[own], side)) continue;
        std::vector<Winding> left;
        for (Winding& piece : pieces) {
            if (is_beside(piece, brushes[other], planes)) {
                left.push_back(std::move(piece));
                continue;
            }
            for (Winding& rest : outside_of(piece, brushes[other], planes)) left.push_back(std::move(rest));
        }
        pieces = std::move(left);
    }
    return pieces;
}

constexpr std::size_t kMaxCandidates = 96;
constexpr long kCutCost = 6;

enum class Side { kOn, kFront, kBack, kBoth };

Side side_of_reach(double lowest, double highest) {
    const bool is_front = highest > kOnEpsilon, is_back = lowest < -kOnEpsilon;
    if (is_front && is_back) return Side::kBoth;
    if (is_front) return Side::kFront;
    return is_back ? Side::kBack : Side::kOn;
}

// A plane that cuts pieces.
class Cutter {
  public:
    Cutter(int index, const PlaneList& planes) : index_(index), type_(planes.type(index)), plane_(planes[index]) {}

    bool is_axial() const { return type_ < 3; }

    // The side of a piece. Pieces of this plane are always kOn.
    Side side_of(const BoundaryPiece& piece) const {
        if (piece.plane.plane == index_) return Side::kOn;
        if (is_axial())
            return side_of_reach(piece.box.mins[type_] - plane_.distance, piece.box.maxs[type_] - plane_.distance);
        const Reach far = reach(piece.winding, plane_);
        return side_of_reach(-far.back, far.front);
    }

  private:
    int index_, type_;
    const Plane& plane_;
};

bool has_only_detail(const std::vector<BoundaryPiece>& pieces) {
    return std::all_of(pieces.begin(), pieces.end(), [](const BoundaryPiece& piece) { return piece.is_detail; });
}

// Every plane of the pieces, or, of many, an even selection, with axial planes first.
std::vector<int> candidates_of(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    std::vector<int> all;
    const bool takes_detail = has_only_detail(pieces);
    for (const BoundaryPiece& piece : pieces) {
        if (takes_detail || !piece.is_detail) all.push_back(piece.plane.plane);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.size() <= kMaxCandidates) return all;
    const auto slanted =
        std::stable_partition(all.begin(), all.end(), [&](int plane) { return planes.type(plane) < 3; });
    const auto axial_count = static_cast<std::size_t>(slanted - all.begin());
    if (axial_count >= kMaxCandidates / 4) all.resize(axial_count);
    std::vector<int> some;
    const std::size_t step = (all.size() + kMaxCandidates - 1) / kMaxCandidates;
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    return some;
}

// `most`: the largest result, returned for all higher costs.
long cost_of(int plane, const std::vector<BoundaryPiece>& pieces, const PlaneList& planes, long most) {
    const Cutter cutter(plane, planes);
    const auto weighted = [&](long cost) { return cutter.is_axial() ? 2 * cost : 3 * cost + 4; };
    long front = 0, back = 0, cuts = 0;
    for (const BoundaryPiece& piece : pieces) {
        const Side side = cutter.side_of(piece);
        if (side == Side::kOn) continue;
        if (side != Side::kBack) ++front;
        if (side != Side::kFront) ++back;
        if (side == Side::kBoth && weighted(kCutCost * ++cuts) >= most) return most;
    }
    return std::min(weighted(kCutCost * cuts + std::labs(front - back)), most);
}

// Chooses the plane of a piece to cut the pieces.
int choose_plane(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    int best = pieces.front().plane.plane;
    long best_cost = std::numeric_limits<long>::max();
    for (const int plane : candidates_of(pieces, planes)) {
        const long cost = cost_of(plane, pieces, planes, best_cost);
        if (cost >= best_cost) continue;
        best = plane;
        best_cost = cost;
    }
    return best;
}

void add_piece(std::vector<BoundaryPiece>& pieces, const BoundaryPiece& whole, Winding winding) {
    const Box box = box_of(winding);
    pieces.push_back({whole.plane, std::move(winding), box, whole.is_detail});
}

// Drops pieces on the plane; cuts those across it.
std::array<std::vector<BoundaryPiece>, 2> parted(std::vector<BoundaryPiece> pieces, int plane,
                                                 const PlaneList& planes) {
    std::array<std::vector<BoundaryPiece>, 2> sides;
    const Cutter cutter(plane, planes);
    for (BoundaryPiece& piece : pieces) {
        const Side side = cutter.side_of(piece);
        if (side == Side::kOn) continue;
        if (side == Side::kBoth) {
            SplitWinding parts = split(std::move(piece.winding), planes[plane]);
            add_piece(sides[0], piece, std::move(parts.front));
            add_piece(sides[1], piece, std::move(parts.back));
            continue;
        }
        sides[side == Side::kBack ? 1 : 0].push_back(std::move(piece));
    }
    return sides;
}

int build(Tree& tree, std::vector<BoundaryPiece> pieces, const PlaneList& planes) {
    if (pieces.empty()) {
        tree.leaves.emplace_back();
        return -static_cast<int>(tree.leaves.size());
    }
    const int plane = choose_plane(pieces, planes);
    const auto index = tree.nodes.size();
    tree.nodes.push_back({plane, {}, has_only_detail(pieces)});
    auto [front, back] = parted(std::move(pieces), plane, planes);
    const int front_child = build(tree, std::move(front), planes);
    const int back_child = build(tree, std::move(back), planes);
    tree.nodes[index].children = {front_child, back_child};
    return static_cast<int>(index);
}

}  // namespace

std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes) {
    const auto touching = touching_brushes(brushes);
    std::vector<BoundaryPiece> pieces;
    for (std::size_t own = 0; own < brushes.size(); ++own) {
        for (const BrushSide& side : brushes[own].sides) {
            for (Winding& part : visible_part(brushes, own, side, touching[own], planes)) {
                const Box box = box_of(part);
                pieces.push_back({side.plane, std::move(part), box, brushes[own].is_detail});
            }
        }
    }
    return pieces;
}

Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes) {
    Tree tree;
    tree.root = build(tree, std::move(pieces), planes);
    return tree;
}

int leaf_at(const Tree& tree, const PlaneList& planes, const Point& point) {
    int child = tree.root;
    while (child >= 0) {
        const TreeNode& node = tree.node(child);
        child = node.children[planes[node.plane].height_of(point) < 0 ? 1 : 0];
    }
    return Tree::leaf_of(child);
}

std::vector<int> leaves_at(const Tree& tree, const PlaneList& planes, const Point& point) {
    std::vector<int> leaves, open{tree.root};
    while (!open.empty()) {
        const int child = open.back();
        open.pop_back();
        if (child < 0) {
            leaves.push_back(Tree::leaf_of(child));
            continue;
        }
        const double height = planes[tree.node(child).plane].height_of(point);
        if (height >= -kOnEpsilon) open.push_back(tree.node(child).children[0]);
        if (height <= kOnEpsilon) open.push_back(tree.node(child).children[1]);
    }
    return leaves;
}

}  // namespace oblong::map
