#pragma once

#include <algorithm>
#include <array>

#include "engine/level/level.h"
#include "game/state.h"

namespace oblong {

/// Nothing of a level is farther than so many units from its origin, along each axis.
inline constexpr std::int32_t kWorldEnd = 32'768;

/// An axis-aligned box in world units, its sides within it.
struct Box {
    Place mins, maxs;

    bool overlaps(const Box& other) const {
        return mins.x <= other.maxs.x && mins.y <= other.maxs.y && mins.z <= other.maxs.z && maxs.x >= other.mins.x &&
               maxs.y >= other.mins.y && maxs.z >= other.mins.z;
    }
    Box moved(const Place& by) const { return {mins + by, maxs + by}; }
    Box grown(const Place& by) const { return {mins - by, maxs + by}; }
    Box united(const Box& other) const {
        return {{std::min(mins.x, other.mins.x), std::min(mins.y, other.mins.y), std::min(mins.z, other.mins.z)},
                {std::max(maxs.x, other.maxs.x), std::max(maxs.y, other.maxs.y), std::max(maxs.z, other.maxs.z)}};
    }
    Place size() const { return maxs - mins; }
};

inline Place place_of(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

/// A box of the file in world units, cut off at the ends of the world: compilers write any number for an empty model.
inline Box box_of(const LevelBox& box) {
    const auto corner = [](const std::array<std::int32_t, 3>& at) {
        const auto within = [](std::int32_t units) { return std::clamp(units, -kWorldEnd, kWorldEnd); };
        return place_of(within(at[0]), within(at[1]), within(at[2]));
    };
    return {corner(box.mins), corner(box.maxs)};
}

/// The player's box at a place: hull 1 of a level is made for it.
inline Box player_box(const Place& place) {
    return Box{place_of(-16, -16, -24), place_of(16, 16, 32)}.moved(place);
}

}  // namespace oblong
