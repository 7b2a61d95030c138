#include "tools/map/tree/surfaces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "engine/base/input_error.h"
#include "tools/map/source/geometry.h"

namespace oblong::map {
namespace {

// A brush may cover points up to this distance outside of it.
constexpr double kCoverSlack = 1.0 / 64;

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

struct TexturedPiece {
    int texinfo = -1;
    Winding winding;
    bool shows_inside = false;
};

// Finds the brush sides whose textures cover parts of a polygon on their plane.
class Texturing {
  public:
    Texturing(const std::vector<Brush>& brushes, const PlaneList& planes) : brushes_(brushes), planes_(planes) {
        for (auto brush = brushes.rbegin(); brush != brushes.rend(); ++brush)
            for (const BrushSide& side : brush->sides) owners_[side.plane].push_back({&*brush, &side});
    }

    // Cuts `winding` into the parts covered by sides with the plane `facing` of brushes with the contents `filling`,
    // later brushes first. Parts without cover (slivers, by rounding) get the texture of the nearest such brush.
    std::vector<TexturedPiece> cover(const Winding& winding, PlaneSide facing, int filling) const {
        std::vector<TexturedPiece> covered;
        std::vector<Winding> bare{winding};
        const auto owners = owners_.find(facing);
        if (owners == owners_.end()) return {{nearest_texinfo(winding, facing, filling), winding}};
        const Box box = box_of(winding);
        for (const Owner& owner : owners->second) {
            if (owner.brush->contents != filling || !owner.brush->box.touches(box, kCoverSlack)) continue;
            std::vector<Winding> still_bare;
            for (const Winding& piece : bare) {
                Winding inside = cut_by_brush(piece, *owner.brush, planes_, still_bare);
                if (!inside.empty())
                    covered.push_back({owner.side->texinfo, std::move(inside), owner.brush->shows_inside});
            }
            bare = std::move(still_bare);
        }
        for (const Winding& piece : bare) covered.push_back({nearest_texinfo(piece, facing, filling), piece});
        return covered;
    }

  private:
    struct Owner {
        const Brush* brush;
        const BrushSide* side;
    };

    int nearest_texinfo(const Winding& winding, PlaneSide facing, int filling) const {
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

    const std::vector<Brush>& brushes_;
    const PlaneList& planes_;
    std::map<PlaneSide, std::vector<Owner>> owners_;  // later brushes first
};

constexpr double kStep = 16;

Plane plane_at_texel(const TexInfo& texinfo, int axis, double texel) {
    const auto i = static_cast<std::size_t>(axis);
    const double size = length(texinfo.axes[i]);
    return {texinfo.axes[i] * (1 / size), (texel - texinfo.offset[i]) / size};
}

// Four times what version 29 can hold (BSP2 holds more): a mistyped texture scale is refused within seconds.
constexpr std::size_t kMostSurfaces = 1 << 18;

void check_count(std::size_t count) {
    if (count > kMostSurfaces)
        throw InputError("lump faces", "more than " + std::to_string(kMostSurfaces) +
                                           " faces, expected larger texture scales or a smaller level");
}

// On planes perpendicular to an axis, at multiples of 1/256, corners are exact.
bool keeps_corners(const Plane& plane) {
    return largest_component(plane.normal) == 1.0 && plane.distance * 256 == std::round(plane.distance * 256);
}

// The plane after the last whole step that fits. If corners are inexact there, rounding puts them on either side, and a
// reader would count one more step for both faces: then the plane is in the middle of a step.
Plane cut_at_step(const TexInfo& texinfo, int axis, double texel) {
    const Plane at_step = plane_at_texel(texinfo, axis, texel);
    return keeps_corners(at_step) ? at_step : plane_at_texel(texinfo, axis, texel - kStep / 2);
}

// Does not cut at a rounding error above a whole step: readers round the same numbers.
std::vector<Winding> cut_along(Winding winding, const TexInfo& texinfo, int axis) {
    std::vector<Winding> pieces;
    while (true) {
        const auto [low, high] = range_of(winding, [&](const Point& point) { return texinfo.texel(axis, point); });
        const double last = std::floor(low / kStep + kOnEpsilon) * kStep + kMaxExtent;
        if (high <= last + kStep * kOnEpsilon) break;
        SplitWinding parts = split(winding, cut_at_step(texinfo, axis, last));
        if (parts.front.empty() || parts.back.empty()) break;
        pieces.push_back(std::move(parts.back));
        check_count(pieces.size());
        winding = std::move(parts.front);
    }
    pieces.push_back(std::move(winding));
    return pieces;
}

// Node, faces back, texinfo: polygons that agree in these may be joined.
using SurfaceKind = std::tuple<int, bool, int>;
using SurfaceGroups = std::map<SurfaceKind, std::vector<Winding>>;

bool is_boundary(const Tree& tree, const Portal& portal) {
    return contents_rank(tree.leaf(portal.leaves[0]).contents) != contents_rank(tree.leaf(portal.leaves[1]).contents);
}

// The brush side at a portal belongs to the leaf of higher rank, and faces the other one.
void add_portal(SurfaceGroups& groups, const Tree& tree, const Portal& portal, const Texturing& texturing) {
    const int front = tree.leaf(portal.leaves[0]).contents, back = tree.leaf(portal.leaves[1]).contents;
    const bool is_owner_front = contents_rank(front) > contents_rank(back);
    const int owner = is_owner_front ? front : back, other = is_owner_front ? back : front;
    if (is_opaque(other)) return;
    const PlaneSide facing{tree.node(portal.node).plane, is_owner_front};
    const Winding outward = is_owner_front ? reversed(portal.winding) : portal.winding;
    for (TexturedPiece& piece : texturing.cover(outward, facing, owner)) {
        if (piece.texinfo < 0) continue;
        const bool is_double = is_liquid(owner) || piece.shows_inside;
        if (is_double) groups[{portal.node, !facing.is_back, piece.texinfo}].push_back(reversed(piece.winding));
        groups[{portal.node, facing.is_back, piece.texinfo}].push_back(std::move(piece.winding));
    }
}

}  // namespace

std::vector<BoundaryPiece> boundaries(const Tree& tree, const Portals& portals) {
    std::map<std::pair<int, bool>, std::vector<Winding>> by_plane;  // plane, whether it is of a detail
    for (const Portal& portal : portals.portals) {
        const TreeNode& node = tree.node(portal.node);
        if (is_boundary(tree, portal)) by_plane[{node.plane, node.is_detail}].push_back(portal.winding);
    }
    std::vector<BoundaryPiece> pieces;
    for (auto& [place, windings] : by_plane)
        for (Winding& winding : merged(std::move(windings)))
            pieces.emplace_back(PlaneSide{place.first, false}, std::move(winding), place.second);
    return pieces;
}

std::vector<Surface> make_surfaces(const Tree& tree, const PlaneList& planes, const Portals& portals,
                                   const std::vector<Brush>& brushes) {
    const Texturing texturing(brushes, planes);
    SurfaceGroups groups;
    for (const Portal& portal : portals.portals)
        if (is_boundary(tree, portal)) add_portal(groups, tree, portal, texturing);
    std::vector<Surface> surfaces;
    for (auto& [kind, windings] : groups) {
        const auto [node, is_back, texinfo] = kind;
        for (Winding& winding : merged(std::move(windings)))
            surfaces.push_back({node, {tree.node(node).plane, is_back}, texinfo, std::move(winding)});
    }
    return surfaces;
}

std::vector<Surface> subdivided(std::vector<Surface> surfaces, const std::vector<TexInfo>& texinfos) {
    std::vector<Surface> result;
    for (Surface& surface : surfaces) {
        const TexInfo& texinfo = item(texinfos, surface.texinfo);
        if (texinfo.is_special) {
            result.push_back(std::move(surface));
            continue;
        }
        for (Winding& strip : cut_along(std::move(surface.winding), texinfo, 0)) {
            for (Winding& piece : cut_along(std::move(strip), texinfo, 1))
                result.push_back({surface.node, surface.plane, surface.texinfo, std::move(piece)});
            check_count(result.size());
        }
    }
    return result;
}

}  // namespace oblong::map
