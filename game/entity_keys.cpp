#include "game/entity_keys.h"

#include <charconv>

#include "engine/fixed/trig.h"
#include "engine/level/entities.h"
#include "game/box.h"

namespace oblong {
namespace {

constexpr std::int32_t kUp = -1, kDown = -2;  // Quake's two angles that are none
constexpr std::int32_t kLargestAngle = 3600;  // degrees; any file may say anything
constexpr Unit kOne = Unit::from_int(1);

World angle_key(const Entity& entity) {
    const World bound = World::from_int(kLargestAngle);
    const auto angles = parse_world_vector(entity.value("angles"));
    if (angles && angles->y <= bound && angles->y >= -bound) return angles->y;
    return number_of(entity, "angle", 0, kLargestAngle);
}

}  // namespace

World number_of(const Entity& entity, const char* key, std::int32_t otherwise, std::int32_t largest) {
    const auto number = parse_decimal(entity.value(key), World::kFractionBits);
    const std::int64_t bound = World::from_int(largest).raw;
    if (!number || *number > bound || *number < -bound) return World::from_int(otherwise);
    return World::from_raw(static_cast<std::int32_t>(*number));
}

std::optional<Place> origin_of(const Entity& entity) {
    const auto origin = parse_world_vector(entity.value("origin"));
    const auto is_within = [](World w) { return w <= World::from_int(kWorldEnd) && w >= World::from_int(-kWorldEnd); };
    const bool is_in_the_world = origin && is_within(origin->x) && is_within(origin->y) && is_within(origin->z);
    return is_in_the_world ? origin : std::nullopt;
}

std::optional<ModelIndex> model_of(const Entity& entity, const Level& level) {
    const std::string name = entity.value("model");
    if (name.size() < 2 || name[0] != '*') return {};
    std::int32_t model = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), model);
    const bool is_number = error == std::errc{} && end == name.data() + name.size();
    const bool is_there = model >= 1 && model < level.models.count();
    return is_number && is_there ? std::optional(ModelIndex(model)) : std::nullopt;
}

Angle yaw_of(const Entity& entity) {
    return degrees_to_angle(convert<Degrees>(angle_key(entity)));
}

Vec3<Unit> direction_of(const Entity& entity) {
    const World angle = angle_key(entity);
    if (angle == World::from_int(kUp)) return {Unit{}, Unit{}, kOne};
    if (angle == World::from_int(kDown)) return {Unit{}, Unit{}, -kOne};
    const Angle yaw = yaw_of(entity);
    return {cosine(yaw), sine(yaw), Unit{}};
}

}  // namespace oblong
