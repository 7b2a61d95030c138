#include "engine/frame/continued_face.h"

#include <algorithm>

#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

namespace {

/// The distance from a place to a face's nearest corner. If it exceeds `farthest`, any larger distance may be returned.
WorldWide distance_of(const Level& level, const Face& face, const Vec3<World>& place, WorldWide farthest) {
    WorldWide nearest = WorldWide::highest();
    for (const SurfEdge step : level.edges_of(face)) {
        const Vec3<WorldWide> way = widening_difference(level.vertices[level.start_of(step)], place);
        if (std::max({absolute(way.x), absolute(way.y), absolute(way.z)}) > farthest) continue;
        nearest = std::min(nearest, length(saturating_convert<World>(way)));
    }
    return nearest;
}

/// Whether two planes are within 60 degrees of each other, so that a texture is stretched by at most 2.
bool is_along(const LevelPlane& a, const LevelPlane& b) {
    return absolute(dot(a.normal, b.normal)) > Sine60::from_raw(std::int64_t{1} << 59);
}

/// The search of continued_face(): nearer sides first, without subtrees that are too far away.
class ContinuedFaceSearch {
  public:
    ContinuedFaceSearch(const Level& level, const WallHit& hit, bool is_back)
        : level_(level),
          plane_(level.nodes[hit.node].plane),
          is_back_(is_back),
          material_(hit.is_sky ? Material::Sky : Material::Lit),
          place_(middle_of(level.leaves[hit.open_leaf].box)) {}

    /// None if no face is suitable.
    FaceIndex find() {
        search(level_.world().root);
        return best_;
    }

  private:
    static constexpr WorldWide kOtherPlanePenalty = WorldWide::from_int(256);

    void search(NodeChild at) {
        if (at.is_leaf()) return;
        const Node& node = level_.nodes[at.node()];
        if (is_too_far(node.box)) return;
        const bool is_behind = plane_distance(level_.planes[node.plane], place_) < PlaneDistance{};
        search(node.children[is_behind]);
        for (const FaceIndex face : node.faces) consider(face);
        search(node.children[!is_behind]);
    }

    void consider(FaceIndex index) {
        const Face& face = level_.faces[index];
        if (level_.texinfos[face.texinfo].material != material_) return;
        const bool is_on_plane = face.plane == plane_ && face.is_back == is_back_;
        if (!is_on_plane && !is_along(level_.planes[face.plane], level_.planes[plane_])) return;
        const WorldWide penalty = is_on_plane ? WorldWide{} : kOtherPlanePenalty, farthest = least_distance_ - penalty;
        const WorldWide distance = distance_of(level_, face, place_, farthest);
        if (distance > farthest || (distance == farthest && index > best_)) return;
        least_distance_ = distance + penalty;
        best_ = index;
    }

    /// Boxes are rounded to whole units, so a face may exceed its node's box by one.
    bool is_too_far(const LevelBox& box) const {
        const auto is_off = [&](std::int32_t least, std::int32_t most, World at) {
            const WorldWide off = convert<WorldWide>(at);
            return WorldWide::from_int(least - 1) - off > least_distance_ ||
                   off - WorldWide::from_int(most + 1) > least_distance_;
        };
        return is_off(box.mins[0], box.maxs[0], place_.x) || is_off(box.mins[1], box.maxs[1], place_.y) ||
               is_off(box.mins[2], box.maxs[2], place_.z);
    }

    const Level& level_;
    PlaneIndex plane_;
    bool is_back_;
    Material material_;
    Vec3<World> place_;
    FaceIndex best_ = FaceIndex::none();
    WorldWide least_distance_ = WorldWide::highest();
};

}  // namespace

FaceIndex continued_face(const WallHit& hit, bool is_back, const Level& level, ContinuedFaces& kept) {
    constexpr std::size_t kMostKept = 4096;  // there are many more pairs of leaves and nodes
    if (kept.size() >= kMostKept) kept.clear();
    const auto [found, is_new] = kept.try_emplace({hit.open_leaf.number(), hit.node.number()});
    if (is_new) found->second = ContinuedFaceSearch(level, hit, is_back).find();
    return found->second;
}

}  // namespace oblong
