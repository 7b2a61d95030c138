#include "engine/library/level_walk.h"

namespace oblong {
namespace {

constexpr World kStep = World::from_int(18);
// The least z of a floor's normal (Quake's 0.7).
constexpr Unit kLeastFloor = Unit::from_raw(751'619'277);

}  // namespace

NearestTrace trace_all(const Surroundings& around, Hull hull, const Vec3<World>& from, const Vec3<World>& to) {
    NearestTrace nearest{trace_hull(around.level, around.level.world(), hull, from, to)};
    for (const PlacedModel& model : around.models) {
        TraceResult hit =
            trace_hull(around.level, around.level.models[model.model], hull, from - model.offset, to - model.offset);
        if (!hit.is_all_solid && hit.fraction >= nearest.fraction) continue;
        hit.end = hit.end + model.offset;
        nearest = {hit, &model};
    }
    return nearest;
}

namespace {

TraceResult trace_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& to) {
    return trace_all(around, Hull::Player, from, to);
}

// A way without its component into a plane.
Vec3<World> along_plane(const Vec3<World>& way, const Vec3<Unit>& normal) {
    const World into = convert<World>(dot(way, normal), Rounding::Floor);
    const auto part = [&](Unit component) { return product<World>(into, component); };
    return {way.x - part(normal.x), way.y - part(normal.y), way.z - part(normal.z)};
}

Vec3<World> slide(const Surroundings& around, Vec3<World> at, Vec3<World> way) {
    constexpr int kMostPlanes = 4;
    for (int plane = 0; plane < kMostPlanes; ++plane) {
        const TraceResult hit = trace_body(around, at, at + way);
        if (hit.is_all_solid) return at;
        const Vec3<World> rest = at + way - hit.end;
        at = hit.end;
        if (!hit.is_hit) return at;
        way = along_plane(rest, hit.normal);
    }
    return at;
}

WorldWide distance_2d(const Vec3<World>& a, const Vec3<World>& b) {
    const WorldWide x = widening_difference(a.x, b.x), y = widening_difference(a.y, b.y);
    return (x < WorldWide{} ? -x : x) + (y < WorldWide{} ? -y : y);
}

}  // namespace

Vec3<World> walk_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& way) {
    const Vec3<World> along_ground = slide(around, from, way);
    if (way.x == World{} && way.y == World{}) return along_ground;
    // The way over a step, up, ahead and down, is taken if it leads farther.
    const Vec3<World> up = trace_body(around, from, from + Vec3<World>{{}, {}, kStep}).end;
    const Vec3<World> over = slide(around, up, {way.x, way.y, {}});
    const TraceResult down = trace_body(around, over, over - Vec3<World>{{}, {}, up.z - from.z});
    const bool is_floor = down.is_hit && down.normal.z >= kLeastFloor;
    return is_floor && distance_2d(down.end, from) > distance_2d(along_ground, from) ? down.end : along_ground;
}

bool stands_on_floor(const Surroundings& around, const Vec3<World>& at) {
    const TraceResult below = trace_body(around, at, at - Vec3<World>{{}, {}, World::from_int(1)});
    return below.is_hit && below.normal.z >= kLeastFloor;
}

}  // namespace oblong
