#include "engine/visibility/fragment_tree.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

namespace {

using Parts = std::vector<std::uint32_t>;  // indices of fragments

class TreeBuilder {
  public:
    TreeBuilder(const Level& level, std::span<const PlacedModel> models, FragmentTree& tree)
        : level_(level), models_(models), tree_(tree) {}

    std::int32_t build(const Parts& parts) {
        if (parts.empty()) return -1;
        const std::uint32_t plane_of = choose_plane(parts);
        FragmentTree::Node node{{plane_of}};
        Parts front, back;
        for (const std::uint32_t part : parts)
            if (part != plane_of) divide(part, plane_of, node, front, back);
        node.front = build(front);
        node.back = build(back);
        tree_.nodes.push_back(std::move(node));
        return static_cast<std::int32_t>(tree_.nodes.size()) - 1;
    }

  private:
    /// Of the first few parts the one whose plane cuts the fewest others.
    std::uint32_t choose_plane(const Parts& parts) {
        constexpr std::size_t kMostTried = 8;
        std::uint32_t best = parts[0];
        std::ptrdiff_t fewest = std::ptrdiff_t{1} << 30;
        for (std::size_t i = 0; i < std::min(parts.size(), kMostTried); ++i) {
            const auto cuts = std::count_if(parts.begin(), parts.end(), [&](std::uint32_t part) {
                return part != parts[i] && side_of(part, parts[i]) == PolygonSide::Both;
            });
            if (cuts < fewest) fewest = cuts, best = parts[i];
        }
        return best;
    }

    PolygonSide side_of(std::uint32_t part, std::uint32_t plane_of) {
        const Fragment& fragment = tree_.fragments[plane_of];
        const Face& face = level_.faces[static_cast<std::size_t>(fragment.face)];
        return polygon_side(level_.planes[static_cast<std::size_t>(face.plane)],
                            models_[static_cast<std::size_t>(fragment.placed)].offset, corners_of(part), distances_);
    }

    std::span<const Vec3<World>> corners_of(std::uint32_t part) const {
        const Fragment& fragment = tree_.fragments[part];
        return std::span(tree_.corners).subspan(fragment.first_corner, fragment.corner_count);
    }

    void divide(std::uint32_t part, std::uint32_t plane_of, FragmentTree::Node& node, Parts& front, Parts& back) {
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

    /// The part of a fragment on one side of the plane that side_of() was asked about last.
    std::uint32_t add_piece(std::uint32_t part, bool in_front) {
        Fragment piece = tree_.fragments[part];
        const auto first = static_cast<std::uint32_t>(tree_.corners.size());
        append_part(tree_.corners, piece.first_corner, distances_, in_front);
        piece.first_corner = first;
        piece.corner_count = static_cast<std::uint32_t>(tree_.corners.size()) - first;
        tree_.fragments.push_back(piece);
        return static_cast<std::uint32_t>(tree_.fragments.size()) - 1;
    }

    const Level& level_;
    std::span<const PlacedModel> models_;
    FragmentTree& tree_;
    std::vector<PlaneDistance> distances_;
};

}  // namespace

FragmentTree build_fragment_tree(const Level& level, std::span<const PlacedModel> models,
                                 std::vector<Fragment> fragments, std::vector<Vec3<World>> corners) {
    FragmentTree tree;
    if (fragments.size() > kMostFragmentsInTree) return tree;
    Parts parts;
    for (std::uint32_t i = 0; i < fragments.size(); ++i) parts.push_back(i);
    tree.fragments = std::move(fragments);
    tree.corners = std::move(corners);
    tree.root = TreeBuilder(level, models, tree).build(parts);
    return tree;
}

}  // namespace oblong
