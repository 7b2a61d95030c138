#include <algorithm>
#include <numeric>

#include "tools/map/tree/tree.h"

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

std::vector<Winding> visible_part(const std::vector<Brush>& brushes, std::size_t own, const BrushSide& side,
                                  const std::vector<std::size_t>& touching, const PlaneList& planes) {
    std::vector<Winding> pieces(1, side.winding), left;
    const Box box = box_of(side.winding);
    for (const std::size_t other : touching) {
        if (pieces.empty()) break;
        if (!brushes[other].box.touches(box, kOnEpsilon)) continue;
        if (!hides(brushes[other], other > own, brushes[own], side)) continue;
        left.clear();
        for (Winding& piece : pieces) {
            if (is_beside(piece, brushes[other], planes))
                left.push_back(std::move(piece));
            else
                cut_by_brush(piece, brushes[other], planes, left);
        }
        std::swap(pieces, left);
    }
    return pieces;
}

}  // namespace

std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes) {
    const auto touching = touching_brushes(brushes);
    std::vector<BoundaryPiece> pieces;
    for (std::size_t own = 0; own < brushes.size(); ++own)
        for (const BrushSide& side : brushes[own].sides)
            for (Winding& part : visible_part(brushes, own, side, touching[own], planes))
                pieces.emplace_back(side.plane, std::move(part), brushes[own].is_detail);
    return pieces;
}

}  // namespace oblong::map
