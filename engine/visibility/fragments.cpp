#include "engine/visibility/fragments.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Corners nearer to a plane than this count as on it: 1/1,024 unit.
constexpr auto kOnTolerance = PlaneDistance::from_raw(std::int64_t{1} << 32);
constexpr PlaneDistance kOnPlane{};

/// Where an edge crosses a plane, computed from its front end, so that both pieces and both faces of the edge agree.
Vec3<World> cross_plane(const Vec3<World>& a, PlaneDistance distance_a, const Vec3<World>& b,
                        PlaneDistance distance_b) {
    const bool a_in_front = distance_a > distance_b;
    const Vec3<World>&front = a_in_front ? a : b, &back = a_in_front ? b : a;
    const PlaneDistance part = a_in_front ? distance_a : distance_b;
    const PlaneDistance whole = a_in_front ? distance_a - distance_b : distance_b - distance_a;
    return between(front, back, part, whole);
}

/// Cuts one face at a time, with a stack of pieces and the nodes that they have reached.
class FaceCutter {
  public:
    FaceCutter(const Level& level, PlacedIndex placed, ModelCut& cut) : level_(level), placed_(placed), cut_(cut) {}

    void cut(FaceIndex face, const Vec3<World>& offset, const FaceTable& table) {
        const auto first = static_cast<std::uint32_t>(cut_.corners.size());
        for (const VertexIndex vertex : table.corners_of(face))
            cut_.corners.push_back(level_.vertices[vertex] + offset);
        pieces_.push_back({level_.world().root, first, static_cast<std::uint32_t>(cut_.corners.size()) - first});
        while (!pieces_.empty()) {
            const Piece piece = pieces_.back();
            pieces_.pop_back();
            if (piece.at.is_leaf())
                add_to_leaf(face, piece);
            else
                send_down(face, piece);
        }
    }

  private:
    struct Piece {
        NodeChild at;
        std::uint32_t first_corner, corner_count;
    };

    void send_down(FaceIndex face, const Piece& piece) {
        const Node& node = level_.nodes[piece.at.node()];
        const LevelPlane& plane = level_.planes[node.plane];
        const auto polygon = std::span(cut_.corners).subspan(piece.first_corner, piece.corner_count);
        const PolygonSide side = polygon_side(plane, {}, polygon, distances_);
        if (side == PolygonSide::Both) return split(piece, node);
        const bool to_front =
            side == PolygonSide::Front || (side == PolygonSide::On && is_seen_from_front(face, plane));
        pieces_.push_back({node.children[to_front ? 0 : 1], piece.first_corner, piece.corner_count});
    }

    /// A face in a node's plane goes to the side from which it is visible.
    bool is_seen_from_front(FaceIndex face, const LevelPlane& plane) const {
        const Face& cut = level_.faces[face];
        const LevelPlane& own = level_.planes[cut.plane];
        return (dot(own.normal, plane.normal) > Sine60{}) != cut.is_back;
    }

    void split(const Piece& piece, const Node& node) {
        for (const int side : {1, 0}) {
            const auto first = static_cast<std::uint32_t>(cut_.corners.size());
            append_part(cut_.corners, piece.first_corner, distances_, side == 0);
            const auto count = static_cast<std::uint32_t>(cut_.corners.size()) - first;
            pieces_.push_back({item(node.children, side), first, count});
        }
    }

    void add_to_leaf(FaceIndex face, const Piece& piece) {
        const LeafIndex leaf = piece.at.leaf();
        if (level_.leaves[leaf].contents == contents::kSolid) return;
        cut_.fragments.push_back({face, leaf, placed_, piece.first_corner, piece.corner_count});
    }

    const Level& level_;
    PlacedIndex placed_;
    ModelCut& cut_;
    std::vector<Piece> pieces_;
    std::vector<PlaneDistance> distances_;
};

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

PolygonSide polygon_side(const LevelPlane& plane, const Vec3<World>& offset, std::span<const Vec3<World>> polygon,
                         std::vector<PlaneDistance>& distances) {
    bool any_front = false, any_back = false;
    distances.clear();
    for (const Vec3<World>& corner : polygon) {
        const PlaneDistance distance = plane_distance(plane, corner - offset);
        distances.push_back(absolute(distance) < kOnTolerance ? kOnPlane : distance);
        any_front |= distances.back() > kOnPlane;
        any_back |= distances.back() < kOnPlane;
    }
    if (any_front && any_back) return PolygonSide::Both;
    return any_front ? PolygonSide::Front : any_back ? PolygonSide::Back : PolygonSide::On;
}

void append_part(std::vector<Vec3<World>>& corners, std::uint32_t first, std::span<const PlaneDistance> distances,
                 bool in_front) {
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const std::size_t next = i + 1 == distances.size() ? 0 : i + 1;
        const Vec3<World> from = corners[first + i], to = corners[first + next];
        const PlaneDistance here = distances[i], there = distances[next];
        if (in_front ? here >= kOnPlane : here <= kOnPlane) corners.push_back(from);
        if ((here < kOnPlane && there > kOnPlane) || (here > kOnPlane && there < kOnPlane))
            corners.push_back(cross_plane(from, here, to, there));
    }
}

ModelCut cut_model(const Level& level, const PlacedModel& model, PlacedIndex placed, const FaceTable& table) {
    ModelCut cut;
    FaceCutter cutter(level, placed, cut);
    for (const FaceIndex face : level.models[model.model].faces) cutter.cut(face, model.offset, table);
    return cut;
}

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
