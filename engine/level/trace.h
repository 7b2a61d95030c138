#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"

namespace oblong {

/// The sizes of bodies for which a level is compiled. Each has its own tree, in which the body is a point.
enum class Hull : std::uint8_t {
    Point,   ///< nodes and leaves
    Player,  ///< a box from (-16, -16, -24) to (16, 16, 32) around the point
    Large    ///< a box from (-32, -32, -24) to (32, 32, 64)
};

/// The result of a move.
struct TraceResult {
    Vec3<World> end;
    Unit fraction = Unit::from_int(1);  ///< of the distance, 0 to 1
    Vec3<Unit> normal;                  ///< of the plane hit, toward the body; 0 if there is none
    bool is_hit = false;
    bool starts_solid = false;  ///< `from` is solid
    bool is_all_solid = false;  ///< the whole line is solid: the body does not move
};

/// The contents (contents::k...) of a model at a point, for a body of the hull's size. A point on a plane belongs to
/// its front. `p` is in the model's coordinates: a world position minus the model's offset.
std::int32_t hull_contents(const Level& level, const SubModel& model, Hull hull, Vec3<World> p);

/// Moves a body in a straight line until it would touch solid: it stops 1/32 unit before the plane, measured along the
/// normal, or at its start if that is nearer. A line that ends in front of the plane is free. The end is never solid
/// unless `from` is; from solid, the body moves out freely, and solid stops it only after that. The line is cut at
/// planes as in Quake's hull check, which may miss solid thinner than 1/32 unit.
TraceResult trace_hull(const Level& level, const SubModel& model, Hull hull, Vec3<World> from, Vec3<World> to);

/// The floor of the world below a point.
struct Floor {
    PlaneIndex plane;
    Vec3<World> position;  ///< straight below the point
};

/// The first solid of the world straight below `from`, through liquids, less than `most` below. None from inside solid,
/// above sky, or if the plane is steeper than 45 degrees. Brush models are not floors.
std::optional<Floor> find_floor(const Level& level, const Vec3<World>& from, World most);

}  // namespace oblong
