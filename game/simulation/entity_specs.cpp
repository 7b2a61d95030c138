#include "game/simulation/entity_specs.h"

#include <algorithm>

#include "engine/fixed/trig.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

constexpr std::int32_t kUpwards = -1, kDownwards = -2;      // values of "angle" that are no yaw
constexpr std::int32_t kLargestAngle = 3600;                // degrees
constexpr std::int32_t kSlowest = 1, kFastestMover = 4000;  // units a second

struct PitchYaw {
    World pitch, yaw;  // degrees, pitch down positive
};

PitchYaw angles_of(const Entity& entity) {
    const World bound = World::from_int(kLargestAngle);
    const auto angles = parse_world_vector(entity.value("angles"));
    if (angles && is_within(angles->x, bound) && is_within(angles->y, bound)) return {angles->x, angles->y};
    return {World{}, number_of(entity, "angle", kLargestAngle)};
}

Unit product(Unit a, Unit b) {
    return convert<Unit>(widening_product(a, b));
}

}  // namespace

std::optional<Position> origin_of(const Entity& entity) {
    const auto origin = parse_world_vector(entity.value("origin"));
    return origin && is_within(*origin, World::from_int(kWorldEnd)) ? origin : std::nullopt;
}

Angle yaw_of(const Entity& entity) {
    return degrees_to_angle(convert<Degrees>(angles_of(entity).yaw));
}

bool has_direction(const Entity& entity) {
    const PitchYaw angles = angles_of(entity);
    return angles.pitch != World{} || angles.yaw != World{};
}

Vec3<Unit> direction_of(const Entity& entity) {
    constexpr Unit kOne = Unit::from_int(1);
    const PitchYaw angles = angles_of(entity);
    if (angles.pitch == World{} && angles.yaw == World::from_int(kUpwards)) return {Unit{}, Unit{}, kOne};
    if (angles.pitch == World{} && angles.yaw == World::from_int(kDownwards)) return {Unit{}, Unit{}, -kOne};
    const Angle yaw = degrees_to_angle(convert<Degrees>(angles.yaw));
    const Angle pitch = degrees_to_angle(convert<Degrees>(angles.pitch));
    if (angles.pitch == World{}) return {cosine(yaw), sine(yaw), Unit{}};
    return {product(cosine(pitch), cosine(yaw)), product(cosine(pitch), sine(yaw)), -sine(pitch)};
}

World number_of(const Entity& entity, const char* key, std::int32_t largest) {
    const World bound = World::from_int(largest);
    const auto number = parse_world_number(entity.value(key));
    if (number && *number != World{} && is_within(*number, bound)) return *number;
    return parse_world_number(usual_text(entity.value("classname"), key)).value_or(World{});
}

World speed_per_tick_of(const Entity& entity) {
    const World speed = number_of(entity, "speed");
    return scaled(std::clamp(speed, World::from_int(kSlowest), World::from_int(kFastestMover)), 1, kTicksPerSecond);
}

std::int32_t ticks_of(const Entity& entity, const char* key) {
    const World seconds = number_of(entity, key);
    if (seconds < World{}) return kForever;
    // Rounded up, except for an excess below 35/4096 of a tick, the number's own rounding: 0.6 s are 21 ticks.
    const std::int64_t ticks_12 = std::int64_t{floor_of<12>(seconds)} * kTicksPerSecond;
    constexpr std::int64_t kAlmostOne = (std::int64_t{1} << World::kFractionBits) - kTicksPerSecond;
    return static_cast<std::int32_t>((ticks_12 + kAlmostOne) >> World::kFractionBits);
}

bool has_flag(const Entity& entity, int flags) {
    const auto value = parse_decimal(entity.value("spawnflags"), 0);
    return value && (*value & flags) != 0;
}

}  // namespace oblong
