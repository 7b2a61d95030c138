#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"

namespace oblong {

/// The sizes of body that a level was compiled for: each has a tree of its own, in which the body is a point.
enum class Hull : std::uint8_t {
    Point,   ///< nodes and leaves
    Player,  ///< a box from (-16, -16, -24) to (16, 16, 32) around the point
    Large    ///< a box from (-32, -32, -24) to (32, 32, 64)
};

/// How far a body went.
struct TraceResult {
    Vec3<World> end;
    Unit fraction = Unit::from_int(1);  ///< of the distance, 0 to 1
    Vec3<Unit> normal;                  ///< of the plane that stopped it, toward the body; 0 if nothing did
    bool is_hit = false;
    bool starts_solid = false;  ///< `from` is solid
    bool is_all_solid = false;  ///< so is the whole line: the body stays where it is
};

/// What fills a model at a point (contents::k...), for a body of the hull's size. A point on a plane belongs to its
/// front. `p` is in the model's own coordinates: a world position minus the model's offset.
std::int32_t hull_contents(const Level& level, const SubModel& model, Hull hull, Vec3<World> p);

/// Moves a body in a straight line until it would touch solid: it stops 1/32 unit before the plane, measured along the
/// normal, or where it starts if that is nearer already. A line that ends in front of the plane is free. The end is
/// never solid unless `from` is; from solid, the body moves out freely and is stopped by what it meets then. The line
/// is cut at planes as in Quake's hull check, which may miss solid thinner than 1/32 unit.
TraceResult trace_hull(const Level& level, const SubModel& model, Hull hull, Vec3<World> from, Vec3<World> to);

/// The floor of the world below a point.
struct Floor {
    PlaneIndex plane;
    Vec3<World> position;  ///< on the plane, straight below the point
};

/// The first solid of the world straight below `from`, at most `most` below it, through liquids. None from solid, above
/// a sky, or where the plane is steeper than 45 degrees. Brush models are no floor.
std::optional<Floor> find_floor(const Level& level, const Vec3<World>& from, World most);

}  // namespace oblong
