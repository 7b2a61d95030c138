#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/level/entity_classes.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/entity_specs.h"

namespace oblong {
namespace {

constexpr int kStartsOpen = 1, kNotLinked = 4;           // spawnflags
const Vec3<World> kDoorReach = world_vector(60, 60, 8);  // from a door that opens for the player

// Sets of linked doors (union-find): the root of a set is its first door.
class DoorSets {
  public:
    explicit DoorSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

    std::size_t find(std::size_t door) {
        while (parents_[door] != door) door = parents_[door] = parents_[parents_[door]];
        return door;
    }
    void unite(std::size_t a, std::size_t b) {
        const auto [first, second] = std::minmax({find(a), find(b)});
        parents_[second] = first;
    }

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
        if (movers[i].kind == MoverKind::Door && !has_flag(*entities[i], kNotLinked))
            doors.push_back({i, model_box(bsp, movers[i].model)});
    return doors;
}

using Axis = World Vec3<World>::*;

// The axis along which the doors are farthest apart, so that the fewest overlap on it.
Axis sorting_axis(const std::vector<LinkedDoor>& doors) {
    Box corners{doors.front().box.mins, doors.front().box.mins};
    for (const LinkedDoor& door : doors) corners = corners.united({door.box.mins, door.box.mins});
    const Vec3<World> size = corners.size();
    if (size.z > std::max(size.x, size.y)) return &Vec3<World>::z;
    return size.y > size.x ? &Vec3<World>::y : &Vec3<World>::x;
}

void unite_touching(std::vector<LinkedDoor> doors, DoorSets& sets) {
    if (doors.empty()) return;
    const Axis axis = sorting_axis(doors);
    std::sort(doors.begin(), doors.end(),
              [&](const LinkedDoor& a, const LinkedDoor& b) { return a.box.mins.*axis < b.box.mins.*axis; });
    for (std::size_t a = 0; a < doors.size(); ++a)
        for (std::size_t b = a + 1; b < doors.size() && doors[b].box.mins.*axis <= doors[a].box.maxs.*axis; ++b)
            if (doors[a].box.overlaps(doors[b].box)) sets.unite(doors[a].mover, doors[b].mover);
}

// What the doors of a group have in common.
struct Group {
    Box whole;
    bool has_keys = false, is_shot = false, is_activated = false, starts_open = false, has_name = false;
    bool opens_from_afar() const { return !has_keys && !is_shot && !is_activated && !(starts_open && has_name); }
};

Group group_of(const Mover& first, const std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
               const std::vector<bool>& is_activated, const Level& bsp) {
    Group group{model_box(bsp, first.model)};
    for (const std::uint32_t i : first.group_members) {
        group.whole = group.whole.united(model_box(bsp, movers[i].model));
        group.has_keys |= movers[i].touch.is_locked();
        group.is_shot |= is_shot(*entities[i]);
        group.is_activated |= is_activated[i];
        group.starts_open |= has_flag(*entities[i], kStartsOpen);
        group.has_name |= !entities[i]->value("targetname").empty();
    }
    return group;
}

}  // namespace

void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp) {
    DoorSets sets(movers.size());
    unite_touching(find_linked_doors(movers, entities, bsp), sets);
    for (std::size_t i = 0; i < movers.size(); ++i) {
        movers[i].group = static_cast<std::uint32_t>(sets.find(i));
        if (movers[i].kind == MoverKind::Door)
            movers[movers[i].group].group_members.push_back(static_cast<std::uint32_t>(i));
    }
}

void make_doors_touchable(std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
                          const std::vector<bool>& is_activated, const Level& bsp) {
    for (std::size_t first = 0; first < movers.size(); ++first) {
        if (movers[first].group_members.empty()) continue;
        const Group group = group_of(movers[first], movers, entities, is_activated, bsp);
        if (group.opens_from_afar()) {
            movers[first].touch.box = group.whole.grown(kDoorReach);
            movers[first].touch.opens = true;
            continue;
        }
        for (const std::uint32_t i : movers[first].group_members) {
            Mover& door = movers[i];
            if (!door.touch.is_locked() && !group.is_shot && movers[first].touch.message == kNoMessage) continue;
            door.touch.box = contact_box(model_box(bsp, door.model)).moved(door.legs.front().from);
            door.touch.opens = door.touch.is_locked() || group.is_shot;
        }
    }
}

namespace {

constexpr std::int32_t kShortestPause_ticks = 4;  // 0.1 s: Quake's trains think at each corner
constexpr std::size_t kMostCorners = 4096;        // of one train

struct Corner {
    Vec3<World> offset;  ///< of the train's model
    std::int32_t pause_ticks = 0;
};

// The corners in the order of the way; after the last one, the way leads back to corner `next`, if there is one.
struct Path {
    std::vector<Corner> corners;
    std::optional<std::size_t> next;
};

Path path_of(const Entity& train, const EntitiesByName& by_name, const Position& model_corner) {
    Path path;
    std::unordered_map<const Entity*, std::size_t> numbers;
    for (const Entity* corner = find_placed(train.value("target"), by_name); corner != nullptr;
         corner = find_placed(corner->value("target"), by_name)) {
        const auto [known, is_new] = numbers.emplace(corner, path.corners.size());
        if (!is_new) path.next = known->second;
        if (!is_new || path.corners.size() == kMostCorners) break;
        const std::int32_t wait = ticks_of(*corner, "wait");
        path.corners.push_back({*origin_of(*corner) - model_corner, wait == 0 ? kShortestPause_ticks : wait});
    }
    return path;
}

Leg leg_between(const Corner& from, const Corner& to, std::size_t next) {
    Leg leg;
    leg.from = from.offset;
    leg.way = to.offset - from.offset;
    leg.length = length_of(leg.way);
    leg.pause_ticks = to.pause_ticks;
    leg.next = static_cast<std::uint32_t>(next);
    return leg;
}

// Leg i leads to corner i + 1. If the way leads back to corner `next`, a last leg leads there, and that corner's leg
// follows it.
std::vector<Leg> legs_of(const Path& path) {
    std::vector<Leg> legs;
    for (std::size_t i = 0; i + 1 < path.corners.size(); ++i)
        legs.push_back(leg_between(path.corners[i], path.corners[i + 1], i + 1));
    if (path.next)
        legs.push_back(leg_between(path.corners.back(), path.corners[*path.next], *path.next));
    else if (legs.empty())
        legs.push_back(leg_between(path.corners.front(), path.corners.front(), 0));
    if (!path.next) legs.back().pause_ticks = kForever;
    if (!path.next) legs.back().next = static_cast<std::uint32_t>(legs.size());
    return legs;
}

}  // namespace

std::optional<Mover> train_of(const Entity& entity, const EntitiesByName& by_name, const Level& bsp, World longest) {
    const auto model = brush_model_of(entity, bsp);
    if (role_of(entity) != ClassRole::Train || !model) return {};
    const Path path = path_of(entity, by_name, model_box(bsp, *model).mins);
    if (path.corners.empty()) return {};
    for (const Corner& corner : path.corners)
        if (!is_within(corner.offset, longest)) return {};
    Mover mover;
    mover.kind = MoverKind::Train;
    mover.model = *model;
    mover.damage = whole_number_of(entity, "dmg");
    mover.legs = legs_of(path);
    mover.speed_per_tick = speed_per_tick_of(entity);
    mover.starts_by_itself = entity.value("targetname").empty();
    return mover;
}

}  // namespace oblong
