#include "game/simulation/collision.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "engine/fixed/arithmetic.h"
#include "engine/level/trace.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

// Calls visit(obstacle) for the world, and the walls and the movers that may be in an area, until visit() returns
// false.
template <class Visit>
bool for_each_obstacle(const GameLevel& level, const GameState& state, const Box& area, Visit visit) {
    if (!visit(Obstacle{kWorldModel, {}})) return false;
    for (const std::uint32_t number : level.boxes.obstacles.part_overlapping(area).numbers)
        if (const auto obstacle = obstacle_of(level, state, number); obstacle && !visit(*obstacle)) return false;
    return true;
}

bool contains(const GameLevel& level, const Obstacle& obstacle, const Position& position) {
    if (!may_touch(level, obstacle.model, obstacle.offset, player_box(position))) return false;
    return hull_contents(*level.bsp, level.model(obstacle.model), Hull::Player, position - obstacle.offset) ==
           contents::kSolid;
}

// The six positions just outside a model, on its sides, above and below.
std::array<Position, 6> positions_around(const GameLevel& level, const Obstacle& obstacle, const Position& from) {
    constexpr World kGap = World::from_int(2);
    const Box model = box_of(level.model(obstacle.model).box).moved(obstacle.offset);
    const Box player = player_box({});
    const Position low = model.mins - player.maxs - Vec3<World>{kGap, kGap, kGap};
    const Position high = model.maxs - player.mins + Vec3<World>{kGap, kGap, kGap};
    return {{{from.x, from.y, high.z},
             {low.x, from.y, from.z},
             {high.x, from.y, from.z},
             {from.x, low.y, from.z},
             {from.x, high.y, from.z},
             {from.x, from.y, low.z}}};
}

// A vector of a length in one of the 27 directions of a 3x3x3 grid, up first; one of them is zero.
Vec3<World> way_in_direction(std::int32_t direction, World length) {
    constexpr std::array<std::int32_t, 3> kSteps{0, 1, -1};
    constexpr std::array<std::int32_t, 4> kShares_12{0, 4096, 2896, 2365};  // of an axis, of two at once, of three
    const std::int32_t z = 1 - direction / 9, x = item(kSteps, direction / 3 % 3), y = item(kSteps, direction % 3);
    const World along = scaled(length, item(kShares_12, std::abs(x) + std::abs(y) + std::abs(z)), 4096);
    return {along * x, along * y, along * z};
}

bool is_reachable(const GameLevel& level, const Position& from, const Position& to) {
    const TraceResult trace = trace_hull(*level.bsp, level.model(kWorldModel), Hull::Player, from, to);
    return !trace.is_hit && !trace.is_all_solid;
}

}  // namespace

std::optional<Obstacle> obstacle_of(const GameLevel& level, const GameState& state, std::uint32_t number) {
    const std::size_t walls = level.solid_walls.size();
    if (number < walls) {
        const std::uint32_t wall = level.solid_walls[number];
        if (state.walls[wall] == WallState::Removed) return {};
        return Obstacle{level.walls[wall], {}};
    }
    const Mover& mover = level.movers[number - walls];
    const MoverState& mover_state = state.movers[number - walls];
    if (is_removed(mover_state)) return {};
    if (mover.turns != 0 && mover_state.travelled != World{}) return {};
    return Obstacle{mover.model, offset_of(mover, mover_state)};
}

bool has_too_many_obstacles(const GameLevel& level, const Position& position) {
    constexpr std::int32_t kFarthest = 48;  // in a tick: 2000 units a second, and a step
    const Box reached = player_box(position).grown(world_vector(kFarthest, kFarthest, kFarthest));
    return level.boxes.obstacles.part_overlapping(reached).next != 0;
}

Contact move_box(const GameLevel& level, const GameState& state, const Position& from, const Position& to) {
    const Box swept = player_box(from).united(player_box(to));
    Contact first{to, false, {}, kWorldModel, false};
    Unit first_fraction = Unit::from_int(1);
    for_each_obstacle(level, state, swept, [&](const Obstacle& obstacle) {
        if (!may_touch(level, obstacle.model, obstacle.offset, swept)) return true;
        const TraceResult trace = trace_hull(*level.bsp, level.model(obstacle.model), Hull::Player,
                                             from - obstacle.offset, to - obstacle.offset);
        if (trace.is_all_solid) {
            first = {from, true, {}, obstacle.model, true};
        } else if (trace.is_hit && (!first.has_hit || trace.fraction < first_fraction)) {
            first = {trace.end + obstacle.offset, true, trace.normal, obstacle.model, false};
            first_fraction = trace.fraction;
        }
        return !first.is_stuck;
    });
    return first;
}

bool is_free(const GameLevel& level, const GameState& state, const Position& position) {
    return for_each_obstacle(level, state, player_box(position),
                             [&](const Obstacle& obstacle) { return !contains(level, obstacle, position); });
}

bool may_touch(const GameLevel& level, ModelIndex model, const Vec3<World>& offset, const Box& box) {
    if (model == kWorldModel) return true;
    return obstacle_box(level, model, offset).overlaps(box);
}

WayOut find_way_out(const GameLevel& level, const GameState& state, const Position& from) {
    std::vector<std::pair<World, Position>> ways;
    for_each_obstacle(level, state, player_box(from), [&](const Obstacle& obstacle) {
        if (obstacle.model == kWorldModel || !contains(level, obstacle, from)) return true;
        for (const Position& position : positions_around(level, obstacle, from))
            ways.emplace_back(length_of(position - from), position);
        return true;
    });
    std::stable_sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    WayOut out{!ways.empty(), {}};
    std::vector<Position> tried;
    for (const auto& [length, position] : ways) {
        if (std::find(tried.begin(), tried.end(), position) != tried.end()) continue;
        if (is_reachable(level, from, position) && is_free(level, state, position)) {
            out.position = position;
            return out;
        }
        if (tried.size() == kMostWaysOut) return out;
        tried.push_back(position);
    }
    return out;
}

Position free_place_near(const GameLevel& level, const Position& from) {
    constexpr std::int32_t kFarthest = 256, kStep = 2, kDirections = 27;
    const auto is_free_of_world = [&](const Position& position) {
        return hull_contents(*level.bsp, level.model(kWorldModel), Hull::Player, position) != contents::kSolid;
    };
    if (is_free_of_world(from)) return from;
    for (std::int32_t length = kStep; length <= kFarthest; length += kStep)
        for (std::int32_t direction = 0; direction < kDirections; ++direction) {
            const Position place = from + way_in_direction(direction, World::from_int(length));
            if (is_free_of_world(place)) return place;
        }
    return from;
}

std::int32_t contents_at(const GameLevel& level, const Position& point) {
    return hull_contents(*level.bsp, level.model(kWorldModel), Hull::Point, point);
}

namespace {

constexpr int kMostBumps = 4;
using Normal = Vec3<Unit>;

bool goes_into_any(const Velocity& v, std::span<const Normal> normals) {
    for (const Normal& normal : normals)
        if (component_along(v, normal) < World{}) return true;
    return false;
}

// v without its component into a surface.
Velocity slide_along(const Velocity& v, const Normal& normal) {
    return v - times(component_along(v, normal), normal);
}

// v along the line where two surfaces meet: (v . c) c / |c|^2 with c their cross product. Nothing for surfaces that are
// nearly parallel.
Velocity along_crease(const Velocity& v, const Normal& a, const Normal& b) {
    using Square = Fixed<std::int64_t, 30>;
    constexpr Square kSmallestSquare = Square::from_raw(1 << 20);  // an angle of 2 degrees
    const Normal crease = convert<Unit>(cross(a, b));
    const auto square = convert<Square>(dot(crease, crease), Rounding::Floor);
    if (square < kSmallestSquare) return {};
    const World part = component_along(v, crease);
    const auto component = [&](Unit c) { return truncated_quotient<World>(widening_product(part, c), square); };
    return {component(crease.x), component(crease.y), component(crease.z)};
}

// v without its components into the surfaces hit so far: along the last surface, or along the crease of two; zero for
// more.
Velocity clip_velocity(const Velocity& v, std::span<const Normal> normals) {
    const Velocity along = slide_along(v, normals.back());
    const auto others = normals.first(normals.size() - 1);
    if (!goes_into_any(along, others)) return along;
    if (others.size() > 1) return {};
    return along_crease(v, others.front(), normals.back());
}

auto level_square(const Position& from, const Position& to) {
    const Vec3<World> way{to.x - from.x, to.y - from.y, World{}};
    return dot(way, way);
}

}  // namespace

Motion slide_move(const GameLevel& level, const GameState& state, const Motion& motion) {
    std::array<Normal, kMostBumps> normals{};
    Motion now = motion;
    Position rest = scaled(motion.velocity, 1, kTicksPerSecond);
    for (std::size_t bump = 0; bump < kMostBumps; ++bump) {
        const Contact contact = move_box(level, state, now.position, now.position + rest);
        if (contact.is_stuck) return {now.position, {}};
        rest = rest - (contact.end - now.position);
        now.position = contact.end;
        if (!contact.has_hit) break;
        normals[bump] = contact.normal;
        const std::span<const Normal> hit(normals.data(), bump + 1);
        now.velocity = clip_velocity(now.velocity, hit);
        rest = clip_velocity(rest, hit);
    }
    return now;
}

Contact find_ground(const GameLevel& level, const GameState& state, const Position& position, World reach) {
    Contact below = move_box(level, state, position, position - Position{World{}, World{}, reach});
    below.has_hit = below.has_hit && !below.is_stuck && below.normal.z >= kGroundNormalZ;
    return below;
}

Motion step_slide_move(const GameLevel& level, const GameState& state, const Motion& motion) {
    const Motion low = slide_move(level, state, motion);
    const Position rise = world_vector(0, 0, kStepHeight);
    const Contact raised = move_box(level, state, motion.position, motion.position + rise);
    Motion high = slide_move(level, state, {raised.end, motion.velocity});
    const World risen = raised.end.z - motion.position.z;
    const Contact ground = find_ground(level, state, high.position, risen);
    if (!ground.has_hit || level_square(motion.position, high.position) <= level_square(motion.position, low.position))
        return low;
    high.position = ground.end;
    high.velocity.z = low.velocity.z;
    return high;
}

}  // namespace oblong
