#pragma once

#include <cstdint>
#include <random>

#include "engine/math/basis.h"
#include "tests/support/point.h"

/// What tests take at random, of a generator that they hand in.
namespace oblong::test {

/// From `low` up to `high`.
double random_between(auto& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
/// 0 to `end` - 1.
std::int32_t random_below(auto& random, std::int32_t end) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(end));
}
Angle random_angle(auto& random) {
    return Angle::from_bam(static_cast<std::int64_t>(random() & 0xffff));
}
Basis random_axes(auto& random) {
    const Angle yaw = random_angle(random), pitch = random_angle(random);
    return view_basis(yaw, pitch, random_angle(random));
}
/// Any bits of each coordinate, shifted down by so many.
Vec3<World> random_world(auto& random, int shift = 0) {
    const auto any = [&] { return World::from_raw(static_cast<std::int32_t>(random()) >> shift); };
    return {any(), any(), any()};
}
std::uint8_t random_byte(auto& random) {
    return static_cast<std::uint8_t>(random());
}
void fill_at_random(auto& bytes, auto& random) {
    for (auto& byte : bytes) byte = random_byte(random);
}

}  // namespace oblong::test
