#include "tools/map/surfaces.h"

#include <map>
#include <tuple>

#include "tools/map/merge.h"
#include "tools/map/texturing.h"

namespace oblong::map {
namespace {

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
        if (is_liquid(owner)) groups[{portal.node, !facing.is_back, piece.texinfo}].push_back(reversed(piece.winding));
        groups[{portal.node, facing.is_back, piece.texinfo}].push_back(std::move(piece.winding));
    }
}

}  // namespace

std::vector<BoundaryPiece> boundaries(const Tree& tree, const Portals& portals) {
    std::map<int, std::vector<Winding>> by_node;
    for (const Portal& portal : portals.portals) {
        if (is_boundary(tree, portal)) by_node[portal.node].push_back(portal.winding);
    }
    std::vector<BoundaryPiece> pieces;
    for (auto& [node, windings] : by_node) {
        for (Winding& winding : merged(std::move(windings))) {
            const Box box = box_of(winding);
            pieces.push_back({{tree.node(node).plane, false}, std::move(winding), box, tree.node(node).is_detail});
        }
    }
    return pieces;
}

std::vector<Surface> make_surfaces(const Tree& tree, const PlaneList& planes, const Portals& portals,
                                   const std::vector<Brush>& brushes) {
    const Texturing texturing(brushes, planes);
    SurfaceGroups groups;
    for (const Portal& portal : portals.portals) {
        if (is_boundary(tree, portal)) add_portal(groups, tree, portal, texturing);
    }
    std::vector<Surface> surfaces;
    for (auto& [kind, windings] : groups) {
        const auto [node, is_back, texinfo] = kind;
        for (Winding& winding : merged(std::move(windings)))
            surfaces.push_back({node, {tree.node(node).plane, is_back}, texinfo, std::move(winding)});
    }
    return surfaces;
}

}  // namespace oblong::map
