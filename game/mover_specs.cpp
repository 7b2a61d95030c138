#include "game/mover_specs.h"

#include <cstdlib>
#include <string>

#include "engine/level/entities.h"
#include "game/entity_keys.h"
#include "game/tick_input.h"

namespace oblong {
namespace {

constexpr int kStartsOpen = 1, kNotLinked = 4;  // spawnflags of func_door
const Place kDoorReach = place_of(60, 60, 8);   // a door opens for who comes as near as this
const Place kButtonReach = place_of(2, 2, 2);
constexpr std::int32_t kLiftInset = 25;
constexpr std::int32_t kSlowest = 1, kFastest = 4000;  // units a second

bool has_flag(const Entity& entity, int flag) {
    const auto flags = parse_decimal(entity.value("spawnflags"), 0);
    return flags && (*flags & flag) != 0;
}

World per_tick(World speed) {
    const World bounded = std::clamp(speed, World::from_int(kSlowest), World::from_int(kFastest));
    return World::from_raw(static_cast<std::int32_t>(bounded.raw / kTicksPerSecond));
}

std::int32_t wait_of(const Entity& entity, std::int32_t otherwise) {
    const World seconds = number_of(entity, "wait", otherwise);
    if (seconds < World{}) return Mover::kForever;
    return static_cast<std::int32_t>(std::int64_t{seconds.raw} * kTicksPerSecond >> World::kFractionBits);
}

// value * direction, rounded; a direction is at most 1 long.
World along(World value, Unit direction) {
    return convert<World>(widening_product(value, direction));
}

World absolute(World value) {
    return World::from_raw(std::abs(value.raw));
}

// How far a door or a button goes: its own size in the direction that it moves, less what stays visible.
World distance_of(const Place& size, const Vec3<Unit>& direction, World lip) {
    const World extent = absolute(along(size.x, direction.x)) + absolute(along(size.y, direction.y)) +
                         absolute(along(size.z, direction.z));
    return std::max(World::from_int(1), extent - lip);
}

Mover sliding(const Entity& entity, const Box& box, std::int32_t lip) {
    const Vec3<Unit> direction = direction_of(entity);
    Mover mover;
    mover.length = distance_of(box.size(), direction, number_of(entity, "lip", lip));
    mover.way = {along(mover.length, direction.x), along(mover.length, direction.y), along(mover.length, direction.z)};
    return mover;
}

Mover door(const Entity& entity, const Box& box) {
    Mover mover = sliding(entity, box, 8);
    mover.speed_per_tick = per_tick(number_of(entity, "speed", 100));
    mover.wait_ticks = wait_of(entity, 3);
    mover.touch = box.grown(kDoorReach);
    if (!has_flag(entity, kStartsOpen)) return mover;
    mover.start = mover.way;
    mover.way = -mover.way;
    return mover;
}

Mover button(const Entity& entity, const Box& box) {
    Mover mover = sliding(entity, box, 4);
    mover.speed_per_tick = per_tick(number_of(entity, "speed", 40));
    mover.wait_ticks = wait_of(entity, 1);
    mover.touch = box.grown(kButtonReach);
    return mover;
}

// The shaft above a lift that waits at its lower end, less a rim that one may pass by on.
Box lift_shaft(const Box& box, World height) {
    const World inset_x = std::min(World::from_int(kLiftInset), World::from_raw(box.size().x.raw / 2));
    const World inset_y = std::min(World::from_int(kLiftInset), World::from_raw(box.size().y.raw / 2));
    const World top = box.maxs.z + World::from_int(8);
    return {{box.mins.x + inset_x, box.mins.y + inset_y, box.maxs.z - height},
            {box.maxs.x - inset_x, box.maxs.y - inset_y, top}};
}

// A lift is drawn at its upper end. It waits below and comes up with the player, unless something else calls it down.
Mover lift(const Entity& entity, const Box& box) {
    const World height = number_of(entity, "height", 0);
    Mover mover;
    mover.length = std::max(World::from_int(1), height > World{} ? height : box.size().z - World::from_int(8));
    mover.speed_per_tick = per_tick(number_of(entity, "speed", 150));
    mover.wait_ticks = 3 * kTicksPerSecond;
    mover.way.z = -mover.length;
    if (!entity.value("targetname").empty()) return mover;
    mover.start.z = -mover.length;
    mover.way.z = mover.length;
    mover.touch = lift_shaft(box, mover.length);
    return mover;
}

bool is_linked_door(const Entity& entity) {
    return entity.value("classname") == "func_door" && !has_flag(entity, kNotLinked);
}

// Spreads the touch boxes of linked doors by one link; true where one has grown.
bool spread_touch(Mover& a, Mover& b) {
    if (!a.touch || !b.touch) return false;
    const Box both = a.touch->united(*b.touch);
    const bool grows = both.mins != a.touch->mins || both.maxs != a.touch->maxs || both.mins != b.touch->mins ||
                       both.maxs != b.touch->maxs;
    a.touch = b.touch = both;
    return grows;
}

}  // namespace

std::optional<Mover> mover_of(const Entity& entity, const Level& level) {
    const auto model = model_of(entity, level);
    if (!model) return {};
    const Box box = box_of(level.models[*model].box);
    const std::string name = entity.value("classname");
    std::optional<Mover> mover;
    if (name == "func_door") mover = door(entity, box);
    if (name == "func_button") mover = button(entity, box);
    if (name == "func_plat") mover = lift(entity, box);
    if (mover) mover->model = *model;
    return mover;
}

void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& level) {
    const auto box = [&](std::size_t i) { return box_of(level.models[movers[i].model].box); };
    std::vector<std::pair<std::size_t, std::size_t>> links;
    for (std::size_t a = 0; a < movers.size(); ++a)
        for (std::size_t b = a + 1; b < movers.size(); ++b)
            if (is_linked_door(*entities[a]) && is_linked_door(*entities[b]) && box(a).overlaps(box(b)))
                links.emplace_back(a, b);
    for (bool has_grown = true; has_grown;) {
        has_grown = false;
        for (const auto& [a, b] : links) has_grown |= spread_touch(movers[a], movers[b]);
    }
}

}  // namespace oblong
