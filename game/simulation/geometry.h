#pragma once

#include <algorithm>

#include "engine/fixed/trig.h"
#include "engine/level/level.h"
#include "engine/math/vec.h"

namespace oblong {

/// Positions in world units, velocities in world units a second.
using Position = Vec3<World>;
using Velocity = Vec3<World>;

/// Positions of starts and of model boxes are within +- this along each axis, in world units.
inline constexpr std::int32_t kWorldEnd = 32'768;

/// A vector of whole world units.
inline Vec3<World> world_vector(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

/// value * part / whole, rounded toward zero. `whole` is not 0; the result must fit.
inline World scaled(World value, std::int64_t part, std::int64_t whole) {
    return convert<World>(convert<WorldWide>(value) * part / whole);
}
inline Vec3<World> scaled(const Vec3<World>& v, std::int64_t part, std::int64_t whole) {
    return {scaled(v.x, part, whole), scaled(v.y, part, whole), scaled(v.z, part, whole)};
}
inline Vec3<World> scaled(const Vec3<World>& v, World part, World whole) {
    return scaled(v, floor_of<12>(part), floor_of<12>(whole));
}

/// value * unit, rounded to nearest.
inline World times(World value, Unit unit) {
    return convert<World>(widening_product(value, unit));
}
inline Vec3<World> times(World value, const Vec3<Unit>& direction) {
    return {times(value, direction.x), times(value, direction.y), times(value, direction.z)};
}

/// Of length 1; pitch down positive.
inline Vec3<Unit> direction_of(Angle yaw, Angle pitch) {
    const auto along = [&](Unit part) { return convert<Unit>(widening_product(cosine(pitch), part)); };
    return {along(cosine(yaw)), along(sine(yaw)), -sine(pitch)};
}

/// The length, rounded down; it must fit.
inline World length_of(const Vec3<World>& v) {
    return convert<World>(length(v));
}

/// v . direction, rounded to nearest.
inline World component_along(const Vec3<World>& v, const Vec3<Unit>& direction) {
    return convert<World>(dot(v, direction));
}

/// A velocity of at most 2000 units a second along each axis, as in Quake.
inline Velocity bounded(const Velocity& v) {
    const auto bound = [most = World::from_int(2000)](World w) { return std::clamp(w, -most, most); };
    return {bound(v.x), bound(v.y), bound(v.z)};
}

/// Whether a number, or every component of a vector, is from -most to most.
inline bool is_within(World value, World most) {
    return value <= most && value >= -most;
}
inline bool is_within(const Vec3<World>& v, World most) {
    return is_within(v.x, most) && is_within(v.y, most) && is_within(v.z, most);
}

/// An axis-aligned box in world units; its sides belong to it.
struct Box {
    Position mins, maxs;

    bool overlaps(const Box& other) const {
        return mins.x <= other.maxs.x && mins.y <= other.maxs.y && mins.z <= other.maxs.z && maxs.x >= other.mins.x &&
               maxs.y >= other.mins.y && maxs.z >= other.mins.z;
    }
    Box moved(const Vec3<World>& by) const { return {mins + by, maxs + by}; }
    Box grown(const Vec3<World>& by) const { return {mins - by, maxs + by}; }
    Box united(const Box& other) const {
        return {{std::min(mins.x, other.mins.x), std::min(mins.y, other.mins.y), std::min(mins.z, other.mins.z)},
                {std::max(maxs.x, other.maxs.x), std::max(maxs.y, other.maxs.y), std::max(maxs.z, other.maxs.z)}};
    }
    Vec3<World> size() const { return maxs - mins; }
};

/// A box of the file in world units, clamped to +-kWorldEnd: compilers write any number for an empty model.
inline Box box_of(const LevelBox& box) {
    const auto corner = [](const auto& at) {
        const auto clamped = [](std::int32_t units) { return std::clamp(units, -kWorldEnd, kWorldEnd); };
        return world_vector(clamped(at[0]), clamped(at[1]), clamped(at[2]));
    };
    return {corner(box.mins), corner(box.maxs)};
}

/// The player's box at a position: the size that hull 1 of a level is compiled for.
inline Box player_box(const Position& position) {
    return Box{world_vector(-16, -16, -24), world_vector(16, 16, 32)}.moved(position);
}

}  // namespace oblong
