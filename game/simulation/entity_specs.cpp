#include "game/simulation/entity_specs.h"

#include <algorithm>
#include <utility>

#include "engine/base/text.h"
#include "engine/fixed/trig.h"
#include "engine/level/entities.h"
#include "engine/scene/placed_models.h"
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

const Vec3<World> kReach = world_vector(32, 32, 32);  // from a monster
constexpr std::size_t kElectrodes = 2;
constexpr World kLargestCell = World::from_int(256);  // of a teleporter that holds one monster

bool is_monster(ClassRole role) {
    return role == ClassRole::Monster || role == ClassRole::Boss || role == ClassRole::LastBoss;
}

bool is_cell(const Box& teleporter) {
    return teleporter.size().x <= kLargestCell && teleporter.size().y <= kLargestCell;
}

// Where the player meets a monster: at the exit of the teleporter that it waits in, if any.
Position meeting_place(const Position& origin, const std::vector<Trigger>& triggers) {
    for (const Trigger& trigger : triggers)
        if (trigger.kind == TriggerKind::Teleport && trigger.needs_activation && is_cell(*trigger.box) &&
            trigger.box->overlaps(player_box(origin)))
            return trigger.place.position;
    return origin;
}

constexpr int kNotTouched = 1, kCounterIsQuiet = 1, kPushesOnce = 1, kHurtIsOff = 1, kTimerIsOn = 1;  // spawnflags
constexpr std::int32_t kPushFactor = 10;
constexpr std::int32_t kStrokes = 3;                      // of lightning; Chthon's health at normal skill
const Vec3<World> kShotReach = world_vector(32, 32, 64);  // from a trigger that Quake activates by a shot

constexpr std::pair<ClassRole, TriggerKind> kTriggerKinds[]{
    {ClassRole::TriggerOnce, TriggerKind::Multiple},     {ClassRole::TriggerMultiple, TriggerKind::Multiple},
    {ClassRole::TriggerSecret, TriggerKind::Multiple},   {ClassRole::TriggerOnlyRegistered, TriggerKind::Multiple},
    {ClassRole::TriggerView, TriggerKind::Multiple},     {ClassRole::Breakable, TriggerKind::Multiple},
    {ClassRole::TriggerRelay, TriggerKind::Relay},       {ClassRole::TriggerCounter, TriggerKind::Counter},
    {ClassRole::TriggerTeleport, TriggerKind::Teleport}, {ClassRole::TriggerPush, TriggerKind::Push},
    {ClassRole::TriggerExit, TriggerKind::Exit},         {ClassRole::TriggerHurt, TriggerKind::Hurt},
    {ClassRole::TriggerLadder, TriggerKind::Ladder},     {ClassRole::Timer, TriggerKind::Timer},
    {ClassRole::TimedSound, TriggerKind::Timer},         {ClassRole::Checkpoint, TriggerKind::Checkpoint},
    {ClassRole::Lightning, TriggerKind::Lightning},
};

std::optional<TriggerKind> trigger_kind(ClassRole role) {
    for (const auto& [its_role, kind] : kTriggerKinds)
        if (its_role == role) return kind;
    return {};
}

// Keys with values that no dial has are left out; the compiler has warned of them.
ViewCondition view_condition_of(const Entity& entity) {
    ViewCondition condition;
    if (has_direction(entity)) condition.direction = direction_of(entity);
    condition.least_cosine = cosine(degrees_to_angle(convert<Degrees>(number_of(entity, "cone", 180))));
    for (std::size_t i = 0; i < kViewDials; ++i) {
        const ViewDial& dial = all_view_dials()[i];
        condition.dials[i] = value_named(dial, entity.value(std::string(dial.key)));
    }
    const auto work = [&](const char* key, std::int32_t otherwise) {
        const std::int32_t number = floor_of(number_of(entity, key));
        return static_cast<std::uint16_t>(number > 0 ? std::min(number, 0xffff) : otherwise);
    };
    condition.least_work = work("least", 0);
    condition.most_work = work("most", ViewCondition::kNoLimit);
    return condition;
}

void read_multiple(const Entity& entity, ClassRole role, Trigger& trigger) {
    trigger.is_secret = role == ClassRole::TriggerSecret;
    const bool fires_again = role == ClassRole::TriggerMultiple || role == ClassRole::TriggerView;
    trigger.wait_ticks = fires_again ? ticks_of(entity, "wait") : kForever;
    if (role == ClassRole::TriggerOnlyRegistered) return;
    if (role == ClassRole::Breakable) {
        trigger.box = contact_box(*trigger.box);
        if (!entity.value("targetname").empty()) trigger.box.reset();
        return;
    }
    if (role == ClassRole::TriggerView) {
        trigger.view = view_condition_of(entity);
        return;
    }
    if (has_flag(entity, kNotTouched))
        trigger.box.reset();
    else if (is_shot(entity))
        trigger.box = trigger.box->grown(kShotReach);
    if (has_direction(entity)) trigger.facing = direction_of(entity);
}

void read_counter(const Entity& entity, Trigger& trigger) {
    trigger.count = std::max(1, whole_number_of(entity, "count"));
    trigger.wait_ticks = kForever;
    trigger.is_quiet = has_flag(entity, kCounterIsQuiet);
}

void read_hurt(const Entity& entity, Trigger& trigger) {
    trigger.damage = whole_number_of(entity, "dmg");
    trigger.wait_ticks = kTicksPerSecond;
    trigger.count = 1;
    trigger.starts_off = has_flag(entity, kHurtIsOff);
}

void read_timer(const Entity& entity, Trigger& trigger) {
    trigger.wait_ticks = std::max(1, ticks_of(entity, "wait"));
    trigger.random_ticks = std::max(0, ticks_of(entity, "random"));
    trigger.count = 1;
    trigger.starts_off = !has_flag(entity, kTimerIsOn);
}

// Any time between the least and the most.
void read_timed_sound(const Entity& entity, Trigger& trigger) {
    const std::int32_t least = std::max(1, ticks_of(entity, "delay")), most = std::max(least, ticks_of(entity, "wait"));
    trigger.random_ticks = (most - least) / 2;
    trigger.wait_ticks = least + trigger.random_ticks;
    trigger.count = 1;
}

// Who stands on a platform at its top does not hang on it.
void read_ladder(const Entity& entity, Trigger& trigger) {
    trigger.box->maxs.z -= World::from_int(2);
    if (has_direction(entity)) trigger.facing = direction_of(entity);
}

void read_push(const Entity& entity, Trigger& trigger) {
    const World speed = number_of(entity, "speed", 4000);
    trigger.push = bounded(times(speed * kPushFactor, direction_of(entity)));
    trigger.wait_ticks = has_flag(entity, kPushesOnce) ? kForever : 0;
}

bool read_checkpoint(const Entity& entity, Trigger& trigger) {
    const auto origin = origin_of(entity);
    if (!origin) return false;
    auto size = parse_world_vector(entity.value("size"));
    if (!size) size = parse_world_vector(usual_text(entity.value("classname"), "size"));
    const auto half = [](World w) { return scaled(std::clamp(w, World{}, World::from_int(kWorldEnd)), 1, 2); };
    trigger.box = Box{*origin, *origin}.grown({half(size->x), half(size->y), half(size->z)});
    trigger.place = {*origin, yaw_of(entity)};
    return true;
}

}  // namespace

Box box_of_class(const ClassBox& box) {
    return {world_vector(box.mins[0], box.mins[1], box.mins[2]), world_vector(box.maxs[0], box.maxs[1], box.maxs[2])};
}

std::optional<Position> origin_of(const Entity& entity) {
    const auto origin = parse_world_vector(entity.value("origin"));
    return origin && is_within(*origin, World::from_int(kWorldEnd)) ? origin : std::nullopt;
}

const Entity* find_placed(const std::string& name, const EntitiesByName& by_name) {
    const auto found = by_name.find(name);
    return found != by_name.end() && origin_of(*found->second) ? found->second : nullptr;
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
    return direction_of(yaw, pitch);
}

World number_of(const Entity& entity, const char* key, std::int32_t largest) {
    const World bound = World::from_int(largest);
    const auto number = parse_world_number(entity.value(key));
    if (number && *number != World{} && is_within(*number, bound)) return *number;
    return parse_world_number(usual_text(entity.value("classname"), key)).value_or(World{});
}

std::int32_t whole_number_of(const Entity& entity, const char* key) {
    return std::max(0, floor_of(number_of(entity, key)));
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

std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    const auto origin = origin_of(entity);
    if (!its_class || !origin) return {};
    const bool is_met = is_monster(its_class->role);
    if (!is_met && its_class->role != ClassRole::Pickup && its_class->role != ClassRole::Health) return {};
    Trigger trigger;
    if (its_class->role == ClassRole::LastBoss) trigger.kind = TriggerKind::Exit;
    trigger.wait_ticks = kForever;
    trigger.box = box_of_class(its_class->box).moved(is_met ? meeting_place(*origin, triggers) : *origin);
    if (is_met) trigger.box = trigger.box->grown(kReach);
    return trigger;
}

std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities) {
    std::vector<std::uint32_t> electrodes;
    for (std::size_t i = 0; i < entities.size() && electrodes.size() < kElectrodes; ++i)
        if (entities[i]->value("target") == "lightning") electrodes.push_back(static_cast<std::uint32_t>(i));
    return electrodes;
}

std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    const auto kind = its_class ? trigger_kind(its_class->role) : std::nullopt;
    if (!kind) return {};
    Trigger trigger;
    trigger.kind = *kind;
    if (its_class->shape == ClassShape::Brush) {
        const auto model = brush_model_of(entity, bsp);
        if (!model) return {};
        trigger.box = model_box(bsp, *model);
    }
    if (trigger.kind == TriggerKind::Multiple) read_multiple(entity, its_class->role, trigger);
    if (trigger.kind == TriggerKind::Counter) read_counter(entity, trigger);
    if (trigger.kind == TriggerKind::Multiple || trigger.kind == TriggerKind::Relay)
        trigger.lenses = whole_number_of(entity, "count");
    if (trigger.kind == TriggerKind::Relay) trigger.found = whole_number_of(entity, "found");
    if (trigger.kind == TriggerKind::Hurt) read_hurt(entity, trigger);
    if (its_class->role == ClassRole::Timer) read_timer(entity, trigger);
    if (its_class->role == ClassRole::TimedSound) read_timed_sound(entity, trigger);
    if (trigger.kind == TriggerKind::Ladder) read_ladder(entity, trigger);
    if (its_class->shape == ClassShape::Point && trigger.kind != TriggerKind::Checkpoint)
        trigger.sounds_from = origin_of(entity);
    if (trigger.kind == TriggerKind::Push) read_push(entity, trigger);
    if (trigger.kind == TriggerKind::Checkpoint && !read_checkpoint(entity, trigger)) return {};
    if (trigger.kind == TriggerKind::Exit) trigger.next_map = entity.value("map");
    if (trigger.kind == TriggerKind::Lightning) trigger.count = kStrokes;
    if (trigger.kind == TriggerKind::Teleport) trigger.needs_activation = !entity.value("targetname").empty();
    return trigger;
}

}  // namespace oblong
