#include <algorithm>
#include <array>
#include <string>

#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "game/simulation/entity_keys.h"
#include "game/simulation/entity_specs.h"

namespace oblong {
namespace {

constexpr int kNotTouched = 1, kCounterIsQuiet = 1, kPushesOnce = 1;  // spawnflags
constexpr std::int32_t kPushFactor = 10;
constexpr World kFastestPush = World::from_int(2000);     // as fast as anything is in Quake, along each axis
constexpr std::int32_t kStrokes = 3;                      // of lightning; Chthon's health at normal skill
const Vec3<World> kShotReach = world_vector(32, 32, 64);  // from what has to be shot

struct TriggerClassRow {
    std::string_view name;
    TriggerKind kind;
    bool has_volume;
};

constexpr std::array kTriggerClasses{
    TriggerClassRow{"trigger_multiple", TriggerKind::Multiple, true},
    TriggerClassRow{"trigger_once", TriggerKind::Multiple, true},
    TriggerClassRow{"trigger_secret", TriggerKind::Multiple, true},
    TriggerClassRow{"trigger_onlyregistered", TriggerKind::Multiple, true},
    TriggerClassRow{"trigger_relay", TriggerKind::Relay, false},
    TriggerClassRow{"trigger_counter", TriggerKind::Counter, false},
    TriggerClassRow{"trigger_teleport", TriggerKind::Teleport, true},
    TriggerClassRow{"trigger_push", TriggerKind::Push, true},
    TriggerClassRow{"trigger_changelevel", TriggerKind::Exit, true},
    TriggerClassRow{"info_checkpoint", TriggerKind::Checkpoint, false},
    TriggerClassRow{"event_lightning", TriggerKind::Lightning, false},
};

void read_multiple(const Entity& entity, const std::string& name, Trigger& trigger) {
    trigger.is_secret = name == "trigger_secret";
    trigger.wait_ticks = name == "trigger_multiple" ? ticks_of(entity, "wait") : kForever;
    if (name == "trigger_onlyregistered") return;
    if (has_flag(entity, kNotTouched))
        trigger.box.reset();
    else if (is_shot(entity))
        trigger.box = trigger.box->grown(kShotReach);
    if (has_direction(entity)) trigger.facing = direction_of(entity);
}

void read_counter(const Entity& entity, Trigger& trigger) {
    const World count = number_of(entity, "count");
    trigger.count = std::max(1, floor_of(count));
    trigger.wait_ticks = kForever;
    trigger.is_quiet = has_flag(entity, kCounterIsQuiet);
}

void read_push(const Entity& entity, Trigger& trigger) {
    const World speed = number_of(entity, "speed", 4000);
    const Velocity push = times(speed * kPushFactor, direction_of(entity));
    const auto bounded = [](World w) { return std::clamp(w, -kFastestPush, kFastestPush); };
    trigger.push = {bounded(push.x), bounded(push.y), bounded(push.z)};
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

std::optional<Trigger> trigger_of(const Entity& entity, const Level& bsp) {
    const std::string name = entity.value("classname");
    const auto row = std::find_if(kTriggerClasses.begin(), kTriggerClasses.end(),
                                  [&](const TriggerClassRow& each) { return each.name == name; });
    if (row == kTriggerClasses.end()) return {};
    Trigger trigger;
    trigger.kind = row->kind;
    if (row->has_volume) {
        const auto model = model_of(entity, bsp);
        if (!model) return {};
        trigger.box = model_box(bsp, *model);
    }
    if (trigger.kind == TriggerKind::Multiple) read_multiple(entity, name, trigger);
    if (trigger.kind == TriggerKind::Counter) read_counter(entity, trigger);
    if (trigger.kind == TriggerKind::Push) read_push(entity, trigger);
    if (trigger.kind == TriggerKind::Checkpoint && !read_checkpoint(entity, trigger)) return {};
    if (trigger.kind == TriggerKind::Exit) trigger.next_map = entity.value("map");
    if (trigger.kind == TriggerKind::Lightning) trigger.count = kStrokes;
    if (trigger.kind == TriggerKind::Teleport) trigger.needs_activation = !entity.value("targetname").empty();
    return trigger;
}

}  // namespace oblong
