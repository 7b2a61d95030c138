#include "engine/visibility/model_cutter.h"

#include "engine/fixed/wide.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

/// Corners nearer to a plane than this are on it, so that no piece is thinner: 1/1,024 unit.
constexpr std::int64_t kOnPlane_42 = std::int64_t{1} << 32;

World interpolate(World from, World to, std::int64_t part, std::int64_t whole) {
    const std::int64_t step = mul_div(std::int64_t{to.raw} - from.raw, part, whole);
    return World::from_raw(static_cast<std::int32_t>(from.raw + step));
}

/// Where an edge crosses a plane, always computed from its front end: both pieces and both faces of the edge agree.
Vec3<World> cross_plane(const Vec3<World>& a, std::int64_t distance_a, const Vec3<World>& b, std::int64_t distance_b) {
    const bool a_in_front = distance_a > distance_b;
    const Vec3<World>&front = a_in_front ? a : b, &back = a_in_front ? b : a;
    const std::int64_t part = a_in_front ? distance_a : distance_b;
    const std::int64_t whole = a_in_front ? distance_a - distance_b : distance_b - distance_a;
    return {interpolate(front.x, back.x, part, whole), interpolate(front.y, back.y, part, whole),
            interpolate(front.z, back.z, part, whole)};
}

bool point_same_way(const Vec3<Unit>& a, const Vec3<Unit>& b) {
    return std::int64_t{a.x.raw} * b.x.raw + std::int64_t{a.y.raw} * b.y.raw + std::int64_t{a.z.raw} * b.z.raw > 0;
}

/// Cuts one face at a time; pieces wait on a stack, each with the node that it has come down to.
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
        distances_.clear();
        bool any_front = false, any_back = false;
        for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
            const std::int64_t distance = plane_distance_42(plane, cut_.corners[piece.first_corner + i]);
            const bool is_on = distance < kOnPlane_42 && distance > -kOnPlane_42;
            distances_.push_back(is_on ? 0 : distance);
            any_front |= !is_on && distance > 0;
            any_back |= !is_on && distance < 0;
        }
        if (any_front && any_back) return split(piece, node);
        const bool to_front = any_front || (!any_back && is_seen_from_front(face, plane));
        pieces_.push_back({node.children[to_front ? 0 : 1], piece.first_corner, piece.corner_count});
    }

    /// A face in a node's plane belongs to the side that it is seen from.
    bool is_seen_from_front(FaceIndex face, const LevelPlane& plane) const {
        const Face& cut = level_.faces[face];
        const LevelPlane& own = level_.planes[cut.plane];
        return point_same_way(own.normal, plane.normal) != cut.is_back;
    }

    void split(const Piece& piece, const Node& node) {
        for (const int side : {1, 0}) {
            const auto first = static_cast<std::uint32_t>(cut_.corners.size());
            for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
                const std::uint32_t next = i + 1 == piece.corner_count ? 0 : i + 1;
                const Vec3<World> from = cut_.corners[piece.first_corner + i],
                                  to = cut_.corners[piece.first_corner + next];
                const std::int64_t here = distances_[i], there = distances_[next];
                if (side == 0 ? here >= 0 : here <= 0) cut_.corners.push_back(from);
                if ((here < 0 && there > 0) || (here > 0 && there < 0))
                    cut_.corners.push_back(cross_plane(from, here, to, there));
            }
            const auto count = static_cast<std::uint32_t>(cut_.corners.size()) - first;
            pieces_.push_back({node.children[static_cast<std::size_t>(side)], first, count});
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
    std::vector<std::int64_t> distances_;
};

}  // namespace

ModelCut cut_model(const Level& level, const PlacedModel& model, PlacedIndex placed, const FaceTable& table) {
    ModelCut cut;
    FaceCutter cutter(level, placed, cut);
    for (const FaceIndex face : level.models[model.model].faces) cutter.cut(face, model.offset, table);
    return cut;
}

}  // namespace oblong
