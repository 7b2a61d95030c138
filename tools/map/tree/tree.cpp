#include "tools/map/tree/tree.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace oblong::map {
namespace {

constexpr std::ptrdiff_t kMaxSlanted = 96;
// Of 10 to 400 on Quake's dm4, e1m7 and end: below, more faces are drawn (30: 1 %); from 150, trees are so uneven that
// up to a seventh more nodes are visited.
constexpr long kCutCost = 60;

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
        if (is_clearly_in_front(piece.box, plane_)) return Side::kFront;
        if (is_clearly_behind(piece.box, plane_)) return Side::kBack;
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

// Every plane of the pieces; of many slanted ones, which cost more to try, an even selection.
std::vector<int> candidates_of(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    std::vector<int> all;
    const bool takes_detail = has_only_detail(pieces);
    for (const BoundaryPiece& piece : pieces)
        if (takes_detail || !piece.is_detail) all.push_back(piece.plane.plane);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const auto slanted =
        std::stable_partition(all.begin(), all.end(), [&](int plane) { return planes.type(plane) < 3; });
    const auto count = all.end() - slanted, step = 1 + count / kMaxSlanted;
    auto kept = slanted;
    for (std::ptrdiff_t i = 0; i < count; i += step) *kept++ = slanted[i];
    all.erase(kept, all.end());
    return all;
}

// How a plane parts pieces.
struct Parting {
    long front = 0, back = 0, cut = 0;  // those cut count in all three

    long cost(bool is_axial) const {
        const long cost = kCutCost * cut + std::labs(front - back);
        return is_axial ? 2 * cost : 3 * cost + 4;
    }
};

// Of a plane that is not axial. Stops if the cost is `most` or more.
Parting parting_by(const Cutter& cutter, const std::vector<BoundaryPiece>& pieces, long most) {
    Parting parting;
    for (const BoundaryPiece& piece : pieces) {
        const Side side = cutter.side_of(piece);
        if (side == Side::kOn) continue;
        if (side != Side::kBack) ++parting.front;
        if (side != Side::kFront) ++parting.back;
        if (side == Side::kBoth && Parting{0, 0, ++parting.cut}.cost(false) >= most) break;
    }
    return parting;
}

// Chooses the plane of a piece to cut the pieces; keeps its memory for the next choice.
class PlaneChooser {
  public:
    explicit PlaneChooser(const PlaneList& planes) : planes_(planes) {}

    int choose(const std::vector<BoundaryPiece>& pieces) {
        candidates_ = candidates_of(pieces, planes_);
        partings_.resize(candidates_.size());
        for (int axis = 0; axis < 3; ++axis) find_partings(pieces, axis);
        int best = pieces.front().plane.plane;
        long best_cost = std::numeric_limits<long>::max();
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const Cutter cutter(candidates_[i], planes_);
            if (!cutter.is_axial()) partings_[i] = parting_by(cutter, pieces, best_cost);
            const long cost = partings_[i].cost(cutter.is_axial());
            if (cost >= best_cost) continue;
            best = candidates_[i];
            best_cost = cost;
        }
        return best;
    }

  private:
    struct AxialPlane {
        double distance = 0;
        std::size_t candidate = 0;
        Parting change{};  // from the plane before
    };

    // Of all candidates along an axis at once: in the order of their distances, a piece is in front of the first ones
    // and behind the last ones.
    void find_partings(const std::vector<BoundaryPiece>& pieces, int axis) {
        along_.clear();
        for (std::size_t i = 0; i < candidates_.size(); ++i)
            if (planes_.type(candidates_[i]) == axis) along_.push_back({planes_[candidates_[i]].distance, i});
        std::sort(along_.begin(), along_.end(),
                  [](const AxialPlane& a, const AxialPlane& b) { return a.distance < b.distance; });
        along_.emplace_back();  // for changes after the last one
        for (const BoundaryPiece& piece : pieces) add_changes(piece.box.mins[axis], piece.box.maxs[axis]);
        along_.pop_back();
        Parting parting{static_cast<long>(pieces.size())};
        for (const AxialPlane& plane : along_) {
            parting.front += plane.change.front;
            parting.back += plane.change.back;
            parting.cut += plane.change.cut;
            partings_[plane.candidate] = parting;
        }
    }

    void add_changes(double low, double high) {
        const auto end = along_.end() - 1;
        const auto front_end = std::partition_point(
            along_.begin(), end, [high](const AxialPlane& plane) { return high - plane.distance > kOnEpsilon; });
        const auto is_behind = [low](const AxialPlane& plane) { return low - plane.distance < -kOnEpsilon; };
        auto back_begin = front_end;  // close to it, as most pieces are small
        while (back_begin != along_.begin() && is_behind(*(back_begin - 1))) --back_begin;
        while (back_begin != end && !is_behind(*back_begin)) ++back_begin;
        --front_end->change.front;
        ++back_begin->change.back;
        if (back_begin >= front_end) return;
        ++back_begin->change.cut;
        --front_end->change.cut;
    }

    const PlaneList& planes_;
    std::vector<int> candidates_;
    std::vector<Parting> partings_;  // of the candidates
    std::vector<AxialPlane> along_;  // the candidates along an axis
};

// Drops pieces on the plane; cuts those across it.
std::array<std::vector<BoundaryPiece>, 2> parted(std::vector<BoundaryPiece> pieces, int plane,
                                                 const PlaneList& planes) {
    std::array<std::vector<BoundaryPiece>, 2> parts;
    const Cutter cutter(plane, planes);
    std::vector<Side> sides;
    sides.reserve(pieces.size());
    std::array<std::size_t, 4> counts{};
    for (const BoundaryPiece& piece : pieces) ++item(counts, sides.emplace_back(cutter.side_of(piece)));
    parts[0].reserve(item(counts, Side::kFront) + item(counts, Side::kBoth));
    parts[1].reserve(item(counts, Side::kBack) + item(counts, Side::kBoth));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        BoundaryPiece& piece = pieces[i];
        if (sides[i] == Side::kOn) continue;
        if (sides[i] == Side::kBoth) {
            SplitWinding halves = split(std::move(piece.winding), planes[plane]);
            parts[0].emplace_back(piece.plane, std::move(halves.front), piece.is_detail);
            parts[1].emplace_back(piece.plane, std::move(halves.back), piece.is_detail);
            continue;
        }
        parts[sides[i] == Side::kBack ? 1 : 0].push_back(std::move(piece));
    }
    return parts;
}

int build(Tree& tree, std::vector<BoundaryPiece> pieces, const PlaneList& planes, PlaneChooser& chooser) {
    if (pieces.empty()) {
        tree.leaves.emplace_back();
        return -static_cast<int>(tree.leaves.size());
    }
    const int plane = chooser.choose(pieces);
    const auto index = tree.nodes.size();
    tree.nodes.push_back({plane, {}, has_only_detail(pieces)});
    auto [front, back] = parted(std::move(pieces), plane, planes);
    const int front_child = build(tree, std::move(front), planes, chooser);
    const int back_child = build(tree, std::move(back), planes, chooser);
    tree.nodes[index].children = {front_child, back_child};
    return static_cast<int>(index);
}

}  // namespace

Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes) {
    Tree tree;
    PlaneChooser chooser(planes);
    tree.root = build(tree, std::move(pieces), planes, chooser);
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
