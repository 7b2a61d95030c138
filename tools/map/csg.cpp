#include "tools/map/csg.h"

#include <algorithm>

namespace oblong::map {
namespace {

// Whether the part of `side` (of `own`) within `other` is hidden by it.
bool hides(const Brush& other, bool is_other_later, const Brush& own, const BrushSide& side) {
    const int other_rank = contents_rank(other.contents), own_rank = contents_rank(own.contents);
    if (other_rank != own_rank) return other_rank > own_rank;
    const bool is_shared = std::any_of(other.sides.begin(), other.sides.end(),
                                       [&](const BrushSide& theirs) { return theirs.plane == side.plane; });
    return !is_shared || is_other_later;
}

std::vector<Winding> visible_part(const std::vector<Brush>& brushes, std::size_t own, const BrushSide& side,
                                  const PlaneList& planes) {
    std::vector<Winding> pieces{side.winding};
    const Box box = box_of(side.winding);
    for (std::size_t other = 0; other < brushes.size() && !pieces.empty(); ++other) {
        if (other == own || !brushes[other].box.touches(box, kOnEpsilon)) continue;
        if (!hides(brushes[other], other > own, brushes[own], side)) continue;
        std::vector<Winding> left;
        for (const Winding& piece : pieces) {
            for (Winding& rest : outside_of(piece, brushes[other], planes)) left.push_back(std::move(rest));
        }
        pieces = std::move(left);
    }
    return pieces;
}

}  // namespace

std::vector<Winding> outside_of(const Winding& winding, const Brush& brush, const PlaneList& planes) {
    std::vector<Winding> outside;
    Winding inside = winding;
    for (const BrushSide& side : brush.sides) {
        SplitWinding parts = split(inside, planes.facing(side.plane));
        if (parts.is_on) continue;
        if (!parts.front.empty()) outside.push_back(std::move(parts.front));
        inside = std::move(parts.back);
        if (inside.empty()) return {winding};
    }
    return outside;
}

std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes) {
    std::vector<BoundaryPiece> pieces;
    for (std::size_t own = 0; own < brushes.size(); ++own) {
        for (const BrushSide& side : brushes[own].sides) {
            for (Winding& part : visible_part(brushes, own, side, planes)) {
                const Box box = box_of(part);
                pieces.push_back({side.plane, std::move(part), box, brushes[own].is_detail});
            }
        }
    }
    return pieces;
}

}  // namespace oblong::map
