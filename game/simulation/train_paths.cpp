#include <vector>

#include "engine/level/entity_classes.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/entity_keys.h"
#include "game/simulation/entity_specs.h"

namespace oblong {
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

const Entity* find_corner(const std::string& name, const EntitiesByName& by_name) {
    const auto found = by_name.find(name);
    return found != by_name.end() && origin_of(*found->second) ? found->second : nullptr;
}

Path path_of(const Entity& train, const EntitiesByName& by_name, const Position& model_corner) {
    Path path;
    std::unordered_map<const Entity*, std::size_t> numbers;
    for (const Entity* corner = find_corner(train.value("target"), by_name); corner != nullptr;
         corner = find_corner(corner->value("target"), by_name)) {
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
    if (!path.next) legs.back().next = 0;
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
    mover.legs = legs_of(path);
    mover.speed_per_tick = speed_per_tick_of(entity);
    mover.starts_by_itself = entity.value("targetname").empty();
    return mover;
}

}  // namespace oblong
