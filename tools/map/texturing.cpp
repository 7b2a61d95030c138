#include "tools/map/texturing.h"

#include <algorithm>
#include <limits>

namespace oblong::map {
namespace {

// A point may be this far outside of a brush that is said to cover it.
constexpr double kCoverSlack = 1.0 / 64;

struct Cover {
    Winding inside;
    std::vector<Winding> outside;
};

Cover cut_by_brush(const Winding& winding, const Brush& brush, PlaneSide on, const PlaneList& planes) {
    Cover cover{winding, {}};
    for (const BrushSide& side : brush.sides) {
        if (side.plane.plane == on.plane) continue;
        SplitWinding parts = split(cover.inside, planes.facing(side.plane));
        if (parts.is_on) continue;
        if (!parts.front.empty()) cover.outside.push_back(std::move(parts.front));
        cover.inside = std::move(parts.back);
        if (cover.inside.empty()) return {{}, {winding}};
    }
    return cover;
}

double greatest_height(const Brush& brush, const PlaneList& planes, const Point& point) {
    double greatest = -std::numeric_limits<double>::max();
    for (const BrushSide& side : brush.sides) greatest = std::max(greatest, planes.facing(side.plane).height_of(point));
    return greatest;
}

const BrushSide& side_facing_most(const Brush& brush, const PlaneList& planes, const Point& direction) {
    const auto facing = [&](const BrushSide& side) { return dot(planes.facing(side.plane).normal, direction); };
    return *std::max_element(brush.sides.begin(), brush.sides.end(),
                             [&](const BrushSide& a, const BrushSide& b) { return facing(a) < facing(b); });
}

}  // namespace

Texturing::Texturing(const std::vector<Brush>& brushes, const PlaneList& planes) : brushes_(brushes), planes_(planes) {
    for (auto brush = brushes.rbegin(); brush != brushes.rend(); ++brush) {
        for (const BrushSide& side : brush->sides) owners_[side.plane].push_back({&*brush, &side});
    }
}

std::vector<TexturedPiece> Texturing::cover(const Winding& winding, PlaneSide facing, int filling) const {
    std::vector<TexturedPiece> covered;
    std::vector<Winding> bare{winding};
    const auto owners = owners_.find(facing);
    if (owners == owners_.end()) return {{nearest_texinfo(winding, facing, filling), winding}};
    const Box box = box_of(winding);
    for (const Owner& owner : owners->second) {
        if (owner.brush->contents != filling || !owner.brush->box.touches(box, kCoverSlack)) continue;
        std::vector<Winding> still_bare;
        for (const Winding& piece : bare) {
            Cover cover = cut_by_brush(piece, *owner.brush, facing, planes_);
            if (!cover.inside.empty()) covered.push_back({owner.side->texinfo, std::move(cover.inside)});
            for (Winding& rest : cover.outside) still_bare.push_back(std::move(rest));
        }
        bare = std::move(still_bare);
    }
    for (Winding& piece : bare) {
        const int texinfo = nearest_texinfo(piece, facing, filling);
        covered.push_back({texinfo, std::move(piece)});
    }
    return covered;
}

int Texturing::nearest_texinfo(const Winding& winding, PlaneSide facing, int filling) const {
    const Point at = middle(winding);
    const Brush* nearest = nullptr;
    double nearest_height = std::numeric_limits<double>::max();
    for (const Brush& brush : brushes_) {
        if (brush.contents != filling) continue;
        const double height = greatest_height(brush, planes_, at);
        if (height > nearest_height) continue;
        nearest = &brush;
        nearest_height = height;
    }
    if (nearest == nullptr) return -1;
    return side_facing_most(*nearest, planes_, planes_.facing(facing).normal).texinfo;
}

}  // namespace oblong::map
