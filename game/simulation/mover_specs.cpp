#include <algorithm>

#include "engine/fixed/trig.h"
#include "engine/level/entity_classes.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

// Spawnflags.
constexpr int kDoorStartsOpen = 1, kDoorNeedsGoldKey = 8, kDoorNeedsSilverKey = 16, kDoorToggles = 32;
constexpr int kTurnsClockwise = 2;
constexpr int kSecretOpensOnce = 1, kSecretFirstLeft = 2, kSecretFirstDown = 4, kSecretIsShot = 16;
constexpr int kLiftLowTrigger = 1;

constexpr std::int32_t kLiftInset = 25;
constexpr std::int32_t kLiftWait_s = 3, kSecretSpeed = 50;

// The extent of a box along a direction, as in Quake's game code: |direction . size|.
World extent_along(const Vec3<Unit>& direction, const Vec3<World>& size) {
    return absolute(component_along(size, direction));
}

Leg leg_along(const Vec3<World>& from, const Vec3<Unit>& direction, World length) {
    Leg leg;
    leg.from = from;
    leg.way = times(length, direction);
    leg.length = length;
    return leg;
}

// A door or a button travels by its extent along its direction, less the lip that stays visible; at least 1.
Mover sliding_mover(const Entity& entity, const Box& box) {
    const Vec3<Unit> direction = direction_of(entity);
    const World extent = extent_along(direction, box.size());
    Mover mover;
    mover.legs = {leg_along({}, direction, std::max(World::from_int(1), extent - number_of(entity, "lip")))};
    mover.speed_per_tick = speed_per_tick_of(entity);
    mover.wait_ticks = ticks_of(entity, "wait");
    return mover;
}

std::uint32_t keys_of(const Entity& entity) {
    if (has_flag(entity, kDoorNeedsGoldKey)) return kGoldKey;  // also if both flags are set, as in Quake
    return has_flag(entity, kDoorNeedsSilverKey) ? kSilverKey : 0;
}

// What all doors have in common.
void make_door(const Entity& entity, Mover& mover) {
    mover.touch.keys = keys_of(entity);
    mover.touch.lenses = whole_number_of(entity, "count");
    const bool is_locked = mover.touch.is_locked() || !entity.value("keyname").empty();
    mover.turns_back = mover.wait_ticks != kForever && !is_locked;
    if (is_locked || has_flag(entity, kDoorToggles)) mover.wait_ticks = kForever;
    mover.toggles = has_flag(entity, kDoorToggles);
}

// Its leg has no way; its length is the door's angle in degrees.
Mover turning_door(const Entity& entity) {
    Mover mover;
    Leg leg;
    leg.length = std::clamp(number_of(entity, "distance"), World::from_int(1), World::from_int(360));
    mover.legs = {leg};
    mover.speed_per_tick = speed_per_tick_of(entity);
    mover.wait_ticks = ticks_of(entity, "wait");
    mover.turns = has_flag(entity, kTurnsClockwise) ? -1 : 1;
    make_door(entity, mover);
    return mover;
}

Mover door(const Entity& entity, const Box& box) {
    Mover mover = sliding_mover(entity, box);
    make_door(entity, mover);
    if (!has_flag(entity, kDoorStartsOpen)) return mover;
    Leg& leg = mover.legs.front();
    leg.from = leg.way;
    leg.way = -leg.way;
    return mover;
}

Mover button(const Entity& entity, const Box& box) {
    Mover mover = sliding_mover(entity, box);
    mover.kind = MoverKind::Button;
    mover.touch.box = contact_box(box);
    return mover;
}

// First back (or down), then sideways.
Mover secret_door(const Entity& entity, const Box& box) {
    const Angle yaw = yaw_of(entity);
    const Vec3<Unit> forward{cosine(yaw), sine(yaw), Unit{}}, right{sine(yaw), -cosine(yaw), Unit{}};
    const Vec3<Unit> down{Unit{}, Unit{}, -Unit::from_int(1)};
    const Vec3<Unit> first = has_flag(entity, kSecretFirstDown)   ? down
                             : has_flag(entity, kSecretFirstLeft) ? -right
                                                                  : right;
    const auto length = [&](const char* key, const Vec3<Unit>& direction) {
        const World given = number_of(entity, key);
        return given > World{} ? given : extent_along(direction, box.size());
    };
    Mover mover;
    mover.kind = MoverKind::SecretDoor;
    mover.legs.push_back(leg_along({}, first, length("t_width", first)));
    mover.legs.push_back(leg_along(mover.legs[0].way, forward, length("t_length", forward)));
    mover.speed_per_tick = scaled(World::from_int(kSecretSpeed), 1, kTicksPerSecond);
    mover.wait_ticks = has_flag(entity, kSecretOpensOnce) ? kForever : ticks_of(entity, "wait");
    mover.touch.opens = entity.value("targetname").empty() || has_flag(entity, kSecretIsShot);
    mover.touch.box = contact_box(box);
    return mover;
}

// Where the player starts a lift: in the shaft above it, inset from its sides; a narrow lift's shaft is a line in its
// middle.
Box lift_shaft(const Entity& entity, const Box& box, World height) {
    const World inset = World::from_int(kLiftInset), unit = World::from_int(1);
    Box shaft{box.mins + Vec3<World>{inset, inset, World{}}, box.maxs - Vec3<World>{inset, inset, World{}}};
    const auto narrow = [&](World Vec3<World>::*axis) {
        if (box.size().*axis > inset + inset) return;
        shaft.mins.*axis = box.mins.*axis + scaled(box.size().*axis, 1, 2);
        shaft.maxs.*axis = shaft.mins.*axis + unit;
    };
    narrow(&Vec3<World>::x);
    narrow(&Vec3<World>::y);
    shaft.mins.z = box.maxs.z - height;
    shaft.maxs.z = (has_flag(entity, kLiftLowTrigger) ? shaft.mins.z : box.maxs.z) + World::from_int(8);
    return shaft;
}

// The model in the file is at the lift's upper end. A lift waits below and goes up with the player; one with a
// targetname waits above until it is activated.
Mover lift(const Entity& entity, const Box& box) {
    const World given = number_of(entity, "height");
    const World height = std::max(World::from_int(1), given > World{} ? given : box.size().z - World::from_int(8));
    Mover mover;
    mover.kind = MoverKind::Lift;
    mover.legs = {leg_along({World{}, World{}, -height}, {Unit{}, Unit{}, Unit::from_int(1)}, height)};
    mover.speed_per_tick = speed_per_tick_of(entity);
    mover.wait_ticks = kLiftWait_s * kTicksPerSecond;
    mover.turns_back = true;
    mover.starts_at_end = !entity.value("targetname").empty();
    mover.touch.box = lift_shaft(entity, box, height);
    return mover;
}

bool keeps_within(const Mover& mover, World longest) {
    return std::all_of(mover.legs.begin(), mover.legs.end(),
                       [&](const Leg& leg) { return leg.length <= longest && is_within(leg.from + leg.way, longest); });
}

}  // namespace

World longest_travel(const Level& bsp) {
    World lowest, highest;
    for (const Vec3<World>& vertex : bsp.vertices) {
        lowest = std::min({lowest, vertex.x, vertex.y, vertex.z});
        highest = std::max({highest, vertex.x, vertex.y, vertex.z});
    }
    const World farthest = std::max(highest, -std::max(lowest, -World::highest()));
    return World::highest() - farthest - World::ulp();  // an ulp for the rounding of directions
}

std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest) {
    const auto model = brush_model_of(entity, bsp);
    if (!model) return {};
    const Box box = model_box(bsp, *model);
    const ClassRole role = role_of(entity);
    std::optional<Mover> mover;
    if (role == ClassRole::Door) mover = door(entity, box);
    if (role == ClassRole::TurningDoor) mover = turning_door(entity);
    if (role == ClassRole::SecretDoor) mover = secret_door(entity, box);
    if (role == ClassRole::Button) mover = button(entity, box);
    if (role == ClassRole::Lift) mover = lift(entity, box);
    if (!mover || !keeps_within(*mover, longest)) return {};
    mover->model = *model;
    mover->damage = whole_number_of(entity, "dmg");
    return mover;
}

bool is_shot(const Entity& entity) {
    return number_of(entity, "health") > World{};
}

Box contact_box(const Box& model) {
    return model.grown(world_vector(2, 2, 2));
}

}  // namespace oblong
