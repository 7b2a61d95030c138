#include "engine/visibility/fragment_tree.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

namespace {

using PartIndex = Index<Fragment>;
using Parts = std::vector<PartIndex>;
using NodeOfTree = Index<FragmentTree::Node>;

class TreeBuilder {
  public:
    TreeBuilder(const Level& level, const Table<PlacedModel>& models, FragmentTree& tree)
        : level_(level), models_(models), tree_(tree) {}

    NodeOfTree build(const Parts& parts) {
        if (parts.empty()) return NodeOfTree::none();
        const PartIndex plane_of = choose_plane(parts);
        FragmentTree::Node node{{plane_of}};
        Parts front, back;
        for (const PartIndex part : parts)
            if (part != plane_of) divide(part, plane_of, node, front, back);
        node.front = build(front);
        node.back = build(back);
        tree_.nodes.push_back(std::move(node));
        return NodeOfTree(tree_.nodes.count() - 1);
    }

  private:
    /// Of the first kMostTried parts, the one whose plane cuts the fewest others.
    PartIndex choose_plane(const Parts& parts) {
        constexpr std::size_t kMostTried = 8;
        PartIndex best = parts[0];
        std::ptrdiff_t fewest = std::ptrdiff_t{1} << 30;
        for (std::size_t i = 0; i < std::min(parts.size(), kMostTried); ++i) {
            const auto cuts = std::count_if(parts.begin(), parts.end(), [&](PartIndex part) {
                return part != parts[i] && side_of(part, parts[i]) == PolygonSide::Both;
            });
            if (cuts < fewest) fewest = cuts, best = parts[i];
        }
        return best;
    }

    PolygonSide side_of(PartIndex part, PartIndex plane_of) {
        const Fragment& fragment = tree_.fragments[plane_of];
        const LevelPlane& plane = level_.planes[level_.faces[fragment.face].plane];
        return polygon_side(plane, models_[fragment.placed].offset, corners_of(part), distances_);
    }

    std::span<const Vec3<World>> corners_of(PartIndex part) const {
        const Fragment& fragment = tree_.fragments[part];
        return std::span(tree_.corners).subspan(fragment.first_corner, fragment.corner_count);
    }

    void divide(PartIndex part, PartIndex plane_of, FragmentTree::Node& node, Parts& front, Parts& back) {
        switch (side_of(part, plane_of)) {
            case PolygonSide::On:
                node.on_plane.push_back(part);
                break;
            case PolygonSide::Front:
                front.push_back(part);
                break;
            case PolygonSide::Back:
                back.push_back(part);
                break;
            case PolygonSide::Both:
                front.push_back(add_piece(part, true));
                back.push_back(add_piece(part, false));
                break;
        }
    }

    /// Adds the part of a fragment on one side of the plane last given to side_of().
    PartIndex add_piece(PartIndex part, bool in_front) {
        Fragment piece = tree_.fragments[part];
        const auto first = static_cast<std::uint32_t>(tree_.corners.size());
        append_part(tree_.corners, piece.first_corner, distances_, in_front);
        piece.first_corner = first;
        piece.corner_count = static_cast<std::uint32_t>(tree_.corners.size()) - first;
        tree_.fragments.push_back(piece);
        return PartIndex(tree_.fragments.count() - 1);
    }

    const Level& level_;
    const Table<PlacedModel>& models_;
    FragmentTree& tree_;
    std::vector<PlaneDistance> distances_;
};

}  // namespace

FragmentTree build_fragment_tree(const Level& level, const Table<PlacedModel>& models, Table<Fragment> fragments,
                                 std::vector<Vec3<World>> corners) {
    FragmentTree tree;
    if (fragments.size() > kMostFragmentsInTree) return tree;
    Parts parts;
    for (const PartIndex part : fragments.indices()) parts.push_back(part);
    tree.fragments = std::move(fragments);
    tree.corners = std::move(corners);
    tree.root = TreeBuilder(level, models, tree).build(parts);
    return tree;
}

}  // namespace oblong
