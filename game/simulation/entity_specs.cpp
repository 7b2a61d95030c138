#include "game/simulation/entity_specs.h"

#include <charconv>
#include <numeric>
#include <string>

#include "engine/fixed/trig.h"
#include "engine/level/entities.h"
#include "engine/scene/light_styles.h"
#include "game/simulation/tick_input.h"

namespace oblong {
namespace {

constexpr int kStartsOpen = 1, kNotLinked = 4;          // spawnflags of func_door
constexpr int kStartsDark = 1;                          // of lights
constexpr std::int64_t kFirstSwitchable = 32;           // light style
constexpr std::int32_t kUpwards = -1, kDownwards = -2;  // values of "angle" that are no yaw
constexpr std::int32_t kLargestAngle = 3600;            // degrees
constexpr std::int32_t kLiftInset = 25;
constexpr std::int32_t kSlowest = 1, kFastest = 4000;    // units a second
const Vec3<World> kDoorReach = world_vector(60, 60, 8);  // a door opens for a player as near as this
const Vec3<World> kButtonReach = world_vector(2, 2, 2);

Box model_box(const Level& bsp, ModelIndex model) {
    return box_of(bsp.models[model].box);
}

// The number of a key in world units; `otherwise` where it is absent, no number, or beyond +-`largest`.
World number_of(const Entity& entity, const char* key, std::int32_t otherwise, std::int32_t largest = kWorldEnd) {
    const World bound = World::from_int(largest);
    const auto number = parse_world_number(entity.value(key));
    if (!number || *number > bound || *number < -bound) return World::from_int(otherwise);
    return *number;
}

World angle_of(const Entity& entity) {
    const World bound = World::from_int(kLargestAngle);
    const auto angles = parse_world_vector(entity.value("angles"));
    if (angles && angles->y <= bound && angles->y >= -bound) return angles->y;
    return number_of(entity, "angle", 0, kLargestAngle);
}

// The direction in which a mover sets out, of length 1.
Vec3<Unit> direction_of(const Entity& entity) {
    constexpr Unit kOne = Unit::from_int(1);
    const World angle = angle_of(entity);
    if (angle == World::from_int(kUpwards)) return {Unit{}, Unit{}, kOne};
    if (angle == World::from_int(kDownwards)) return {Unit{}, Unit{}, -kOne};
    const Angle yaw = yaw_of(entity);
    return {cosine(yaw), sine(yaw), Unit{}};
}

bool has_flag(const Entity& entity, int flag) {
    const auto flags = parse_decimal(entity.value("spawnflags"), 0);
    return flags && (*flags & flag) != 0;
}

World per_tick(World speed) {
    return scaled(std::clamp(speed, World::from_int(kSlowest), World::from_int(kFastest)), 1, kTicksPerSecond);
}

std::int32_t wait_ticks_of(const Entity& entity, std::int32_t otherwise) {
    const World seconds = number_of(entity, "wait", otherwise);
    if (seconds < World{}) return Mover::kForever;
    return static_cast<std::int32_t>(floor_of(bounded_product(seconds, Fixed<std::int64_t, 0>{kTicksPerSecond})));
}

// How far a door or a button travels: its extent along its direction, less the lip that stays visible; as Quake's game,
// |direction * size| - lip, but at least 1.
World travel_length(const Vec3<World>& size, const Vec3<Unit>& direction, World lip) {
    const World extent = absolute(times(size.x, direction.x)) + absolute(times(size.y, direction.y)) +
                         absolute(times(size.z, direction.z));
    return std::max(World::from_int(1), extent - lip);
}

Mover sliding_mover(const Entity& entity, const Box& box, std::int32_t lip, std::int32_t speed, std::int32_t wait) {
    const Vec3<Unit> direction = direction_of(entity);
    Mover mover;
    mover.length = travel_length(box.size(), direction, number_of(entity, "lip", lip));
    mover.travel = times(mover.length, direction);
    mover.speed_per_tick = per_tick(number_of(entity, "speed", speed));
    mover.wait_ticks = wait_ticks_of(entity, wait);
    return mover;
}

Mover door(const Entity& entity, const Box& box) {
    Mover mover = sliding_mover(entity, box, 8, 100, 3);
    mover.touch_box = box.grown(kDoorReach);
    if (!has_flag(entity, kStartsOpen)) return mover;
    mover.start = mover.travel;
    mover.travel = -mover.travel;
    return mover;
}

Mover button(const Entity& entity, const Box& box) {
    Mover mover = sliding_mover(entity, box, 4, 40, 1);
    mover.touch_box = box.grown(kButtonReach);
    mover.is_button = true;
    return mover;
}

// The shaft above a lift that waits at its lower end, less a rim where the player may pass by.
Box lift_shaft(const Box& box, World height) {
    const auto inset = [](World side) { return std::min(World::from_int(kLiftInset), scaled(side, 1, 2)); };
    const World inset_x = inset(box.size().x), inset_y = inset(box.size().y);
    const World top = box.maxs.z + World::from_int(8);
    return {{box.mins.x + inset_x, box.mins.y + inset_y, box.maxs.z - height},
            {box.maxs.x - inset_x, box.maxs.y - inset_y, top}};
}

// A lift's model is at its upper end. It waits below and comes up with the player, unless something else calls it down.
Mover lift(const Entity& entity, const Box& box) {
    const World height = number_of(entity, "height", 0);
    Mover mover;
    mover.length = std::max(World::from_int(1), height > World{} ? height : box.size().z - World::from_int(8));
    mover.speed_per_tick = per_tick(number_of(entity, "speed", 150));
    mover.wait_ticks = 3 * kTicksPerSecond;
    mover.travel.z = -mover.length;
    if (!entity.value("targetname").empty()) return mover;
    mover.start.z = -mover.length;
    mover.travel.z = mover.length;
    mover.touch_box = lift_shaft(box, mover.length);
    return mover;
}

// Sets of linked doors (union-find): each door's parent, up to the one that represents its set.
class DoorSets {
  public:
    explicit DoorSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

    std::size_t find(std::size_t door) {
        while (parents_[door] != door) door = parents_[door] = parents_[parents_[door]];
        return door;
    }
    void unite(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

  private:
    std::vector<std::size_t> parents_;
};

struct LinkedDoor {
    std::size_t mover;
    Box box;
};

std::vector<LinkedDoor> find_linked_doors(const std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
                                          const Level& bsp) {
    std::vector<LinkedDoor> doors;
    for (std::size_t i = 0; i < movers.size(); ++i)
        if (entities[i]->value("classname") == "func_door" && !has_flag(*entities[i], kNotLinked))
            doors.push_back({i, model_box(bsp, movers[i].model)});
    return doors;
}

using Axis = World Vec3<World>::*;

// The axis along which the doors are farthest apart, so that the fewest overlap.
Axis sorting_axis(const std::vector<LinkedDoor>& doors) {
    Box corners{doors.front().box.mins, doors.front().box.mins};
    for (const LinkedDoor& door : doors) corners = corners.united({door.box.mins, door.box.mins});
    const Vec3<World> size = corners.size();
    if (size.z > std::max(size.x, size.y)) return &Vec3<World>::z;
    return size.y > size.x ? &Vec3<World>::y : &Vec3<World>::x;
}

}  // namespace

std::optional<Position> origin_of(const Entity& entity) {
    const auto origin = parse_world_vector(entity.value("origin"));
    const auto is_inside = [](World w) { return w <= World::from_int(kWorldEnd) && w >= World::from_int(-kWorldEnd); };
    if (!origin || !is_inside(origin->x) || !is_inside(origin->y) || !is_inside(origin->z)) return {};
    return origin;
}

Angle yaw_of(const Entity& entity) {
    return degrees_to_angle(convert<Degrees>(angle_of(entity)));
}

std::optional<ModelIndex> model_of(const Entity& entity, const Level& bsp) {
    const std::string name = entity.value("model");
    if (name.size() < 2 || name[0] != '*') return {};
    std::int32_t model = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), model);
    const bool is_number = error == std::errc{} && end == name.data() + name.size();
    const bool is_there = model >= 1 && model < bsp.models.count();
    return is_number && is_there ? std::optional(ModelIndex(model)) : std::nullopt;
}

World longest_travel(const Level& bsp) {
    World lowest, highest;
    for (const Vec3<World>& vertex : bsp.vertices) {
        lowest = std::min({lowest, vertex.x, vertex.y, vertex.z});
        highest = std::max({highest, vertex.x, vertex.y, vertex.z});
    }
    const World farthest = std::max(highest, -std::max(lowest, -World::highest()));
    return World::highest() - farthest - World::ulp();  // a step for the rounding of directions
}

std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest) {
    const auto model = model_of(entity, bsp);
    if (!model) return {};
    const Box box = model_box(bsp, *model);
    const std::string name = entity.value("classname");
    std::optional<Mover> mover;
    if (name == "func_door") mover = door(entity, box);
    if (name == "func_button") mover = button(entity, box);
    if (name == "func_plat") mover = lift(entity, box);
    if (!mover || mover->length > longest) return {};
    mover->model = *model;
    return mover;
}

std::optional<SwitchableLight> switchable_light_of(const Entity& entity) {
    if (!entity.value("classname").starts_with("light") || entity.value("targetname").empty()) return {};
    const auto style = parse_decimal(entity.value("style"), 0);
    if (!style || *style < kFirstSwitchable || *style >= kLightStyleCount) return {};
    return SwitchableLight{std::uint64_t{1} << *style, has_flag(entity, kStartsDark)};
}

void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp) {
    std::vector<LinkedDoor> doors = find_linked_doors(movers, entities, bsp);
    if (doors.empty()) return;
    const Axis axis = sorting_axis(doors);
    std::sort(doors.begin(), doors.end(),
              [&](const LinkedDoor& a, const LinkedDoor& b) { return a.box.mins.*axis < b.box.mins.*axis; });
    DoorSets sets(movers.size());
    for (std::size_t a = 0; a < doors.size(); ++a)
        for (std::size_t b = a + 1; b < doors.size() && doors[b].box.mins.*axis <= doors[a].box.maxs.*axis; ++b)
            if (doors[a].box.overlaps(doors[b].box)) sets.unite(doors[a].mover, doors[b].mover);
    for (const LinkedDoor& door : doors) {
        std::optional<Box>& whole = movers[sets.find(door.mover)].touch_box;
        whole = whole->united(*movers[door.mover].touch_box);
    }
    for (const LinkedDoor& door : doors) movers[door.mover].touch_box = movers[sets.find(door.mover)].touch_box;
}

}  // namespace oblong
