#include "game/simulation/slide_move.h"

#include <array>
#include <cstddef>
#include <span>

#include "engine/fixed/arithmetic.h"
#include "game/simulation/tick_input.h"

namespace oblong {
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
