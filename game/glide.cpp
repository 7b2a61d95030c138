#include "game/glide.h"

#include <array>
#include <cstddef>
#include <span>

#include "game/velocity.h"

namespace oblong {
namespace {

constexpr int kMostBumps = 4;
using Normal = Vec3<Unit>;

bool goes_into(const Velocity& v, const Normal& normal) {
    return dot(v, normal) < World{};
}

bool goes_into_any(const Velocity& v, std::span<const Normal> normals) {
    for (const Normal& normal : normals)
        if (goes_into(v, normal)) return true;
    return false;
}

Normal cross(const Normal& a, const Normal& b) {
    const auto part = [](Unit p, Unit q, Unit r, Unit s) {
        return convert<Unit>(widening_product(p, q) - widening_product(r, s));
    };
    return {part(a.y, b.z, a.z, b.y), part(a.z, b.x, a.x, b.z), part(a.x, b.y, a.y, b.x)};
}

// v along the line where two surfaces meet: (v . c) c / |c|^2 with c their cross product. Nothing for surfaces that are
// nearly parallel.
Velocity along_crease(const Velocity& v, const Normal& a, const Normal& b) {
    constexpr std::int64_t kSmallestSquare = std::int64_t{1} << 20;  // 2.30: an angle of 2 degrees
    const Normal crease = cross(a, b);
    const auto square = widening_product(crease.x, crease.x) + widening_product(crease.y, crease.y) +
                        widening_product(crease.z, crease.z);
    const std::int64_t square_30 = floor_shift(square.raw, Unit::kFractionBits);
    if (square_30 < kSmallestSquare) return {};
    const World part = dot(v, crease);
    const auto component = [&](Unit c) {
        return World::from_raw(static_cast<std::int32_t>(widening_product(part, c).raw / square_30));
    };
    return {component(crease.x), component(crease.y), component(crease.z)};
}

// v freed of all that goes into the surfaces hit so far: along the last one, or where it meets another; else nothing.
Velocity freed(const Velocity& v, std::span<const Normal> normals) {
    const Velocity along = slide_along(v, normals.back());
    const auto others = normals.first(normals.size() - 1);
    if (!goes_into_any(along, others)) return along;
    if (others.size() > 1) return {};
    return along_crease(v, others.front(), normals.back());
}

std::int64_t flat_square(const Place& from, const Place& to) {
    const std::int64_t x = std::int64_t{to.x.raw} - from.x.raw, y = std::int64_t{to.y.raw} - from.y.raw;
    return x * x + y * y;
}

}  // namespace

Motion glide(const Stage& stage, const GameState& state, const Motion& motion) {
    std::array<Normal, kMostBumps> normals{};
    Motion now = motion;
    Place rest = moved_in_a_tick(motion.velocity);
    for (std::size_t bump = 0; bump < kMostBumps; ++bump) {
        const Contact contact = move_box(stage, state, now.place, now.place + rest);
        if (contact.is_stuck) return {now.place, {}};
        rest = rest - (contact.end - now.place);
        now.place = contact.end;
        if (!contact.has_hit) break;
        normals[bump] = contact.normal;
        const std::span<const Normal> hit(normals.data(), bump + 1);
        now.velocity = freed(now.velocity, hit);
        rest = freed(rest, hit);
    }
    return now;
}

Contact find_ground(const Stage& stage, const GameState& state, const Place& place, World reach) {
    Contact below = move_box(stage, state, place, place - Place{World{}, World{}, reach});
    below.has_hit = below.has_hit && !below.is_stuck && below.normal.z >= kLevelEnough;
    return below;
}

Motion glide_over_steps(const Stage& stage, const GameState& state, const Motion& motion) {
    const Motion low = glide(stage, state, motion);
    const Place rise = place_of(0, 0, kStepHeight);
    const Contact raised = move_box(stage, state, motion.place, motion.place + rise);
    Motion high = glide(stage, state, {raised.end, motion.velocity});
    const World risen = raised.end.z - motion.place.z;
    const Contact ground = find_ground(stage, state, high.place, risen);
    if (!ground.has_hit || flat_square(motion.place, high.place) <= flat_square(motion.place, low.place)) return low;
    high.place = ground.end;
    high.velocity.z = low.velocity.z;
    return high;
}

}  // namespace oblong
