#include <algorithm>

#include "engine/level/entities.h"
#include "engine/library/level_state.h"
#include "engine/view/views.h"

namespace oblong {
namespace {

// Places of bodies, their ways and offsets of brushes stay so near that their sums fit: levels do not reach as far.
constexpr World kFarthestMoved = World::from_int(100'000);
World within_walks(World along) {
    constexpr World kFarthest = World::from_int(200'000);
    return std::clamp(along, -kFarthest, kFarthest);
}

Vec3<World> walker_of(const Pose& eye) {
    const Vec3<World> place = place_of(eye);
    return {within_walks(place.x), within_walks(place.y), within_walks(place.z)};
}

// Quake's box of the player, which things have, too.
Bounds bounds_of_body(const Vec3<World>& origin) {
    const auto beside = [&](std::int32_t aside, std::int32_t up) {
        return pose_of(origin + Vec3<World>{World::from_int(aside), World::from_int(aside), World::from_int(up)});
    };
    return {beside(-16, -24), beside(16, 32)};
}

}  // namespace

Pose LevelScene::walked(const Pose& eye, const Pose& wanted) const {
    const Vec3<World> below_eye{{}, {}, kEyeAboveOrigin};
    const auto part = [](std::int64_t from, std::int64_t to) { return within_walks(world_from_256(to - from)); };
    const Vec3<World> way{part(eye.x_256, wanted.x_256), part(eye.y_256, wanted.y_256), part(eye.z_256, wanted.z_256)};
    const Vec3<World> at = walk_body(state_->surroundings(), walker_of(eye) - below_eye, way) + below_eye;
    Pose after = wanted;
    after.x_256 = to_256(at.x);
    after.y_256 = to_256(at.y);
    after.z_256 = to_256(at.z);
    return after;
}

bool LevelScene::stands(const Pose& eye) const {
    return stands_on_floor(state_->surroundings(), walker_of(eye) - Vec3<World>{{}, {}, kEyeAboveOrigin});
}

std::int32_t LevelScene::find_entity(const std::string& key, const std::string& value, std::int32_t after) const {
    const std::vector<Entity>& entities = state_->level.entities;
    const auto begin =
        entities.begin() + std::clamp<std::ptrdiff_t>(std::ptrdiff_t{after} + 1, 0, std::ssize(entities));
    const auto found =
        std::find_if(begin, entities.end(), [&](const Entity& entity) { return entity.value(key) == value; });
    return found == entities.end() ? -1 : static_cast<std::int32_t>(found - entities.begin());
}

std::string LevelScene::entity_value(std::int32_t entity, const std::string& key) const {
    return state_->entity(entity).value(key);
}

void LevelScene::move_entity(std::int32_t entity, std::int32_t east_256, std::int32_t north_256, std::int32_t up_256) {
    State& state = *state_;
    const ModelIndex model = state.brushes_of(entity);
    const auto within = [](std::int32_t offset_256) {
        return std::clamp(world_from_256(offset_256), -kFarthestMoved, kFarthestMoved);
    };
    if (state.turning_door(entity)) state.refuse(entity, "turns, expected a door that moves");
    for (EntityBrushes& each : state.brushes)
        if (each.placed.model == model) each.placed.offset = {within(east_256), within(north_256), within(up_256)};
    state.list_brushes();
}

void LevelScene::turn_entity(std::int32_t entity, std::int32_t degrees_256) {
    State& state = *state_;
    const ModelIndex model = state.brushes_of(entity);
    const std::optional<std::size_t> door = state.turning_door(entity);
    if (!door) state.refuse(entity, "does not turn, expected a func_door_rotating");
    state.turned[*door] = angle_from_256(degrees_256);
    for (EntityBrushes& each : state.brushes)
        if (each.placed.model == model) each.is_open = state.turned[*door] != Angle{};
    state.list_brushes();
}

void LevelScene::hide_entity(std::int32_t entity, bool is_hidden) {
    State& state = *state_;
    state.entity(entity);  // which is there
    bool is_found = false;
    for (std::size_t i = 0; i < state.models.models.size(); ++i)
        if (state.models.models[i].entity == as_size(entity)) {
            state.is_model_hidden[i] = is_hidden ? 1 : 0;
            is_found = true;
        }
    for (EntityBrushes& each : state.brushes)
        if (each.entity == entity) {
            each.is_hidden = is_hidden;
            is_found = true;
        }
    if (!is_found) state.refuse(entity, "is not seen, expected brushes or a model");
    state.list_brushes();
}

Bounds LevelScene::entity_bounds(std::int32_t entity) const {
    const State& state = *state_;
    const std::optional<ModelIndex> model = brush_model_of(state.entity(entity), state.level);
    if (!model) {
        const Vec3<World> origin = entity_origin(state.entity(entity));
        return bounds_of_body({within_walks(origin.x), within_walks(origin.y), within_walks(origin.z)});
    }
    Bounds bounds;
    const LevelBox& box = state.level.models[*model].box;
    bounds = {pose_at(box.mins[0], box.mins[1], box.mins[2]), pose_at(box.maxs[0], box.maxs[1], box.maxs[2])};
    for (const EntityBrushes& each : state.brushes)
        if (each.entity == entity)
            for (Pose* corner : {&bounds.least, &bounds.greatest}) {
                corner->x_256 += to_256(each.placed.offset.x);
                corner->y_256 += to_256(each.placed.offset.y);
                corner->z_256 += to_256(each.placed.offset.z);
            }
    return bounds;
}

Pose LevelScene::entity_pose(std::int32_t entity) const {
    const Entity& its = state_->entity(entity);
    Pose pose = pose_of(entity_origin(its));
    if (brush_model_of(its, state_->level)) {
        const auto [least, greatest] = entity_bounds(entity);
        pose = {(least.x_256 + greatest.x_256) / 2, (least.y_256 + greatest.y_256) / 2,
                (least.z_256 + greatest.z_256) / 2};
    }
    pose.yaw_256 = entity_yaw_256(its);
    return pose;
}

bool LevelScene::touches(const Pose& eye, std::int32_t entity) const {
    const Bounds body = bounds_of_body(walker_of(eye) - Vec3<World>{{}, {}, kEyeAboveOrigin}),
                 its = entity_bounds(entity);
    const auto meet = [&](std::int32_t Pose::*axis) {
        return body.least.*axis <= its.greatest.*axis && its.least.*axis <= body.greatest.*axis;
    };
    return meet(&Pose::x_256) && meet(&Pose::y_256) && meet(&Pose::z_256);
}

Hit LevelScene::ray(const Pose& from, std::int32_t length) const {
    const State& state = *state_;
    const Vec3<Unit> ahead = first_person_view(camera_of(from, 90)).axes.forward;
    const World most = within_walks(World::from_int(std::clamp(length, 0, 200'000)));
    const Vec3<World> eye = walker_of(from);
    const NearestTrace met = trace_all(
        state.surroundings(), Hull::Point, eye,
        eye + Vec3<World>{product<World>(most, ahead.x), product<World>(most, ahead.y), product<World>(most, ahead.z)});
    Hit hit{from, met.is_hit || met.is_all_solid, -1};
    hit.place.x_256 = to_256(met.end.x);
    hit.place.y_256 = to_256(met.end.y);
    hit.place.z_256 = to_256(met.end.z);
    for (const EntityBrushes& each : state.brushes)
        if (met.model && each.placed.model == met.model->model) hit.entity = each.entity;
    return hit;
}

}  // namespace oblong
