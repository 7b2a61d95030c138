#include "engine/frame/brush_models.h"

#include <algorithm>

#include "engine/fixed/wide.h"
#include "engine/frame/frame.h"
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
Vec3<World> cross(const Vec3<World>& a, std::int64_t distance_a, const Vec3<World>& b, std::int64_t distance_b) {
    const bool a_in_front = distance_a > distance_b;
    const Vec3<World>&front = a_in_front ? a : b, &back = a_in_front ? b : a;
    const std::int64_t part = a_in_front ? distance_a : distance_b;
    const std::int64_t whole = a_in_front ? distance_a - distance_b : distance_b - distance_a;
    return {interpolate(front.x, back.x, part, whole), interpolate(front.y, back.y, part, whole),
            interpolate(front.z, back.z, part, whole)};
}

/// The model's faces that face the eye, nearest first by its own tree.
void order_faces(const Level& level, const SubModel& model, const Vec3<World>& local_eye,
                 std::vector<std::int32_t>& steps, std::vector<std::int32_t>& faces) {
    // A step is a node to enter, or ~node whose near side is done.
    faces.clear();
    steps.assign(1, model.head_nodes[0]);
    while (!steps.empty()) {
        const std::int32_t step = steps.back();
        steps.pop_back();
        const Node& node = level.nodes[static_cast<std::size_t>(step < 0 ? ~step : step)];
        const LevelPlane& plane = level.planes[static_cast<std::size_t>(node.plane)];
        const std::int64_t distance = plane_distance_42(plane, local_eye);
        const bool in_front = distance > 0;
        if (step < 0) {
            for (std::int32_t face = node.first_face; face < node.first_face + node.face_count; ++face)
                if (level.faces[static_cast<std::size_t>(face)].is_back != in_front) faces.push_back(face);
            continue;
        }
        if (node.children[in_front] >= 0) steps.push_back(node.children[in_front]);
        steps.push_back(~step);
        if (node.children[!in_front] >= 0) steps.push_back(node.children[!in_front]);
    }
}

std::int64_t squared_distance(const SubModel& model, const PlacedModel& placed, const Vec3<World>& eye) {
    const auto part = [](std::int32_t low, std::int32_t high, World offset, World at) {
        const std::int64_t middle = (std::int64_t{low} + high) / 2 + floor_shift(std::int64_t{offset.raw} - at.raw, 12);
        return middle * middle;
    };
    return part(model.box.mins[0], model.box.maxs[0], placed.offset.x, eye.x) +
           part(model.box.mins[1], model.box.maxs[1], placed.offset.y, eye.y) +
           part(model.box.mins[2], model.box.maxs[2], placed.offset.z, eye.z);
}

}  // namespace

void ModelFragments::clear() {
    for (const std::int32_t leaf : touched_) first_[static_cast<std::size_t>(leaf)] = -1;
    touched_.clear();
    fragments_.clear();
    corners_.clear();
}

void ModelFragments::cut(const Level& level, std::span<const PlacedModel> models, const FaceTable& table,
                         const Vec3<World>& eye) {
    const auto distance_of = [&](std::int32_t index) {
        const PlacedModel& placed = models[static_cast<std::size_t>(index)];
        return squared_distance(level.models[static_cast<std::size_t>(placed.model)], placed, eye);
    };
    order_.clear();
    for (std::size_t i = 0; i < models.size(); ++i) order_.push_back(static_cast<std::int32_t>(i));
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        const std::int64_t distance_a = distance_of(a), distance_b = distance_of(b);
        return distance_a != distance_b ? distance_a < distance_b : a < b;
    });
    for (const std::int32_t index : order_)
        cut_model(level, models[static_cast<std::size_t>(index)], index, table, eye);
}

void ModelFragments::cut_model(const Level& level, const PlacedModel& placed, std::int32_t model_index,
                               const FaceTable& table, const Vec3<World>& eye) {
    const SubModel& model = level.models[static_cast<std::size_t>(placed.model)];
    if (model.head_nodes[0] < 0) return;
    order_faces(level, model, eye - placed.offset, nodes_, faces_);
    for (const std::int32_t face : faces_) {
        const Cut cut{level, level.faces[static_cast<std::size_t>(face)], face, model_index};
        cut_face(cut, placed.offset, table);
    }
}

void ModelFragments::cut_face(const Cut& cut, const Vec3<World>& offset, const FaceTable& table) {
    pieces_.clear();
    const auto first = static_cast<std::uint32_t>(corners_.size());
    for (const std::int32_t vertex : table.corners_of(cut.face_index))
        corners_.push_back(cut.level.vertices[static_cast<std::size_t>(vertex)] + offset);
    pieces_.push_back({cut.level.models[0].head_nodes[0], first, static_cast<std::uint32_t>(corners_.size()) - first});
    while (!pieces_.empty()) {
        const Piece piece = pieces_.back();
        pieces_.pop_back();
        if (piece.node < 0)
            add_to_leaf(cut, -1 - piece.node, piece);
        else
            cut_piece(cut, piece);
    }
}

void ModelFragments::cut_piece(const Cut& cut, const Piece& piece) {
    const Node& node = cut.level.nodes[static_cast<std::size_t>(piece.node)];
    const LevelPlane& plane = cut.level.planes[static_cast<std::size_t>(node.plane)];
    distances_.clear();
    bool any_front = false, any_back = false;
    for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
        const std::int64_t distance = plane_distance_42(plane, corners_[piece.first_corner + i]);
        const bool is_on = distance < kOnPlane_42 && distance > -kOnPlane_42;
        distances_.push_back(is_on ? 0 : distance);
        any_front |= !is_on && distance > 0;
        any_back |= !is_on && distance < 0;
    }
    if (any_front && any_back) return split(piece, node);
    // A face in the plane belongs to the side that it is seen from.
    const LevelPlane& own = cut.level.planes[static_cast<std::size_t>(cut.face.plane)];
    const bool agrees = std::int64_t{own.normal.x.raw} * plane.normal.x.raw +
                            std::int64_t{own.normal.y.raw} * plane.normal.y.raw +
                            std::int64_t{own.normal.z.raw} * plane.normal.z.raw >
                        0;
    const bool to_front = any_front || (!any_back && agrees != cut.face.is_back);
    pieces_.push_back({node.children[to_front ? 0 : 1], piece.first_corner, piece.corner_count});
}

void ModelFragments::split(const Piece& piece, const Node& node) {
    for (const int side : {1, 0}) {
        const auto first = static_cast<std::uint32_t>(corners_.size());
        for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
            const std::uint32_t next = i + 1 == piece.corner_count ? 0 : i + 1;
            const Vec3<World> from = corners_[piece.first_corner + i], to = corners_[piece.first_corner + next];
            const std::int64_t here = distances_[i], there = distances_[next];
            if (side == 0 ? here >= 0 : here <= 0) corners_.push_back(from);
            if ((here < 0 && there > 0) || (here > 0 && there < 0)) corners_.push_back(cross(from, here, to, there));
        }
        pieces_.push_back({node.children[static_cast<std::size_t>(side)], first,
                           static_cast<std::uint32_t>(corners_.size()) - first});
    }
}

void ModelFragments::add_to_leaf(const Cut& cut, std::int32_t leaf, const Piece& piece) {
    if (cut.level.leaves[static_cast<std::size_t>(leaf)].contents == contents::kSolid) return;
    const auto index = static_cast<std::int32_t>(fragments_.size());
    fragments_.push_back({cut.face_index, cut.model_index, piece.first_corner, piece.corner_count, -1});
    std::int32_t& first = first_[static_cast<std::size_t>(leaf)];
    if (first < 0) {
        first = index;
        touched_.push_back(leaf);
    } else {
        fragments_[static_cast<std::size_t>(last_[static_cast<std::size_t>(leaf)])].next = index;
    }
    last_[static_cast<std::size_t>(leaf)] = index;
}

}  // namespace oblong
