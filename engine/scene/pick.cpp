#include "engine/scene/pick.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/table.h"
#include "engine/level/side.h"
#include "engine/math/basis.h"
#include "engine/math/soft_float.h"

namespace oblong {

namespace {

/// Distances that differ by less may be in the wrong order, as each is rounded once.
constexpr RayDistance kSlack = RayDistance::from_raw(4);

/// A pending part of the ray in the walk down the tree.
struct RayStep {
    NodeChild at;
    RayDistance from, to;
    bool tests_faces;  ///< tests the faces on the node's plane, which the ray meets at `from`
};

/// A ray through the tree of one model, in the model's coordinates.
class RayWalk {
  public:
    RayWalk(const Level& level, const Vec3<World>& eye, const Vec3<Unit>& direction)
        : level_(level), eye_(eye), direction_(direction) {
        // Viewspace along the ray: there the ray is the origin of the x-y plane.
        axes_.forward = direction;
        axes_.right = perpendicular_to(direction);
        axes_.up = normalised(cross(axes_.right, direction));
    }

    std::optional<PickedFace> first_face(NodeChild root, RayDistance farthest) {
        steps_.assign(1, {root, RayDistance{}, farthest, false});
        while (!steps_.empty()) {
            const RayStep step = steps_.back();
            steps_.pop_back();
            if (step.tests_faces) {
                const FaceIndex face = face_at(level_.nodes[step.at.node()]);
                if (face != FaceIndex::none())
                    return PickedFace{face, PlacedIndex::none(), step.from, point_on_ray(eye_, direction_, step.from)};
            } else if (!step.at.is_leaf()) {
                enter(step);
            }
        }
        return std::nullopt;
    }

  private:
    Plane plane_of(const Node& node) const {
        const LevelPlane& plane = level_.planes[node.plane];
        return {plane.normal, plane.distance};
    }

    void enter(const RayStep& step) {
        const Node& node = level_.nodes[step.at.node()];
        const bool is_back = plane_side(level_.planes[node.plane], eye_) <= 0;
        const NodeChild near = node.children[is_back], far = node.children[!is_back];
        const std::optional<RayDistance> meets = intersect_ray(eye_, direction_, plane_of(node));
        if (!meets || *meets < RayDistance{} || *meets > step.to + kSlack) {
            steps_.push_back({near, step.from, step.to, false});
            return;
        }
        steps_.push_back({far, std::max(step.from, *meets - kSlack), step.to, false});
        if (*meets < step.from - kSlack) return;
        steps_.push_back({step.at, *meets, *meets, true});
        steps_.push_back({near, step.from, std::min(step.to, *meets + kSlack), false});
    }

    /// The face on a node's plane that faces the eye and that the ray goes through.
    FaceIndex face_at(const Node& node) const {
        const int side = plane_side(level_.planes[node.plane], eye_);
        for (const FaceIndex face : node.faces)
            if (side == (level_.faces[face].is_back ? -1 : 1) && is_through(level_.faces[face])) return face;
        return FaceIndex::none();
    }

    /// Whether the ray goes through a face: seen along the ray, it is on the inner side of each edge, or on it.
    bool is_through(const Face& face) const {
        const std::span<const SurfEdge> edges = level_.edges_of(face);
        return std::all_of(edges.begin(), edges.end(), [this](SurfEdge edge) {
            const Edge& ends = level_.edges[edge.edge()];
            const int turn = turn_about(ends.from, ends.to);
            return (edge.is_reversed() ? -turn : turn) <= 0;
        });
    }

    /// The sign of the turn from one corner to another around the ray; negative is clockwise.
    int turn_about(VertexIndex from, VertexIndex to) const {
        const Vec3<View> a = to_view(level_.vertices[from], eye_, axes_), b = to_view(level_.vertices[to], eye_, axes_);
        WideSum turn;
        turn.add_product(a.x, b.y);
        turn.add_product(-a.y, b.x);
        const std::int64_t sign = turn.scaled(0).mantissa;
        return (sign > 0) - (sign < 0);
    }

    const Level& level_;
    Vec3<World> eye_;
    Vec3<Unit> direction_;
    Basis axes_;
    std::vector<RayStep> steps_;
};

}  // namespace

std::optional<PickedFace> pick_face(const Level& level, std::span<const PlacedModel> models, const Vec3<World>& eye,
                                    const Vec3<Unit>& direction) {
    // Farther than from one end of any world to the other.
    constexpr RayDistance kFarthest = RayDistance::from_int(1 << 21);
    std::optional<PickedFace> nearest = RayWalk(level, eye, direction).first_face(level.world().root, kFarthest);
    for (std::int32_t i = 0; i < std::ssize(models); ++i) {
        const PlacedModel& placed = item(models, i);
        const auto eye_in_model = saturating_convert<World>(widening_difference(eye, placed.offset));
        std::optional<PickedFace> found =
            RayWalk(level, eye_in_model, direction)
                .first_face(level.models[placed.model].root, nearest ? nearest->distance : kFarthest);
        if (!found || (nearest && found->distance >= nearest->distance)) continue;
        nearest = found;
        nearest->model = PlacedIndex(i);
        nearest->world_point = point_on_ray(eye, direction, found->distance);
    }
    return nearest;
}

const Entity* entity_of(const Level& level, ModelIndex model) {
    const std::string name = "*" + std::to_string(model.number());
    const auto found = std::find_if(level.entities.begin(), level.entities.end(),
                                    [&](const Entity& entity) { return entity.value("model") == name; });
    return found == level.entities.end() ? nullptr : &*found;
}

}  // namespace oblong
