#include <algorithm>
#include <numeric>

#include "game/simulation/entity_keys.h"
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
        group.has_keys |= movers[i].touch.keys != 0;
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
            if (door.touch.keys == 0 && !group.is_shot && movers[first].touch.message == kNoMessage) continue;
            door.touch.box = contact_box(model_box(bsp, door.model)).moved(door.legs.front().from);
            door.touch.opens = door.touch.keys != 0 || group.is_shot;
        }
    }
}

}  // namespace oblong
