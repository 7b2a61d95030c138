#include "game/velocity.h"

#include "game/tick_input.h"

namespace oblong {
namespace {

World quotient(std::int64_t numerator, std::int64_t denominator) {
    return World::from_raw(static_cast<std::int32_t>(numerator / denominator));
}

}  // namespace

// A bit at a time from the top: each is kept where the square stays within.
std::int64_t integer_root(std::int64_t square) {
    std::int64_t root = 0;
    for (std::int64_t bit = std::int64_t{1} << 31; bit > 0; bit >>= 1)
        if ((root + bit) <= square / (root + bit)) root += bit;
    return root;
}

World length_of(const Velocity& v) {
    const auto square = [](World w) { return std::int64_t{w.raw} * w.raw; };
    return World::from_raw(static_cast<std::int32_t>(integer_root(square(v.x) + square(v.y) + square(v.z))));
}

World dot(const Velocity& v, const Vec3<Unit>& direction) {
    return convert<World>(widening_product(v.x, direction.x) + widening_product(v.y, direction.y) +
                          widening_product(v.z, direction.z));
}

Velocity scaled(const Velocity& v, World part, World whole) {
    const auto scale = [&](World w) { return quotient(std::int64_t{w.raw} * part.raw, whole.raw); };
    return {scale(v.x), scale(v.y), scale(v.z)};
}

Velocity slide_along(const Velocity& v, const Vec3<Unit>& normal) {
    const World into = dot(v, normal);
    const auto part = [&](Unit n) { return convert<World>(widening_product(into, n)); };
    return v - Velocity{part(normal.x), part(normal.y), part(normal.z)};
}

Place moved_in_a_tick(const Velocity& v) {
    return {quotient(v.x.raw, kTicksPerSecond), quotient(v.y.raw, kTicksPerSecond), quotient(v.z.raw, kTicksPerSecond)};
}

}  // namespace oblong
