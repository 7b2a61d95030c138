#include "engine/effects/particles.h"

#include <algorithm>

#include "engine/fixed/sine_methods.h"

namespace oblong {

namespace {

/// A particle's random numbers, 16 bits each.
struct Chance {
    std::uint64_t bits;

    Chance(std::uint32_t seed, std::int32_t index)
        : bits((std::uint64_t{seed} << 32) + static_cast<std::uint32_t>(index)) {
        // The mixer of SplitMix64 (Steele, Lea and Flood 2014).
        bits = (bits + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
        bits ^= bits >> 31;
    }
    /// 0 to 65,535; `which` 0 to 3.
    std::int32_t share_16(int which) const { return static_cast<std::int32_t>(bits >> (16 * which) & 0xffff); }
    /// The same from -32,768 to 32,767.
    std::int32_t signed_15(int which) const { return share_16(which) - 32768; }
    /// Where in the period it begins; mixed once more, so that it does not depend on the shares.
    std::uint32_t phase() const { return static_cast<std::uint32_t>((bits * 0x9e3779b97f4a7c15) >> 32); }
};

/// size * share / 2^bits, toward minus infinity.
World part_of(World size, std::int64_t share, int bits) {
    return World::from_raw(static_cast<std::int32_t>(floor_shift(floor_of<12>(size) * share, bits)));
}

/// size * sin(phase).
World wave(World size, std::uint32_t phase) {
    const Unit height = sine(Angle{static_cast<std::uint16_t>(phase >> 16)}, SineMethod::Lerp256);
    return part_of(size, floor_of<30>(height), 30);
}

/// The amplitude of particles' swing along an axis of the box.
World swing_in(World half_size, World most) {
    return std::min(half_size / 8, most);
}

/// A random place along an axis of the box that leaves room for the swing.
World place_along(World half_size, World swing, std::int32_t chance_15) {
    return part_of(half_size - swing, chance_15, 15);
}

/// A drop's position relative to the middle of its box. It falls for 7/8 of the period; then the splash hops toward the
/// middle, so that it stays in the box.
Vec3<World> rain_at(const Vec3<World>& half_size, const Chance& chance, std::uint32_t phase) {
    constexpr std::uint32_t kFall_16 = 7 * 8192;
    const World x = part_of(half_size.x, chance.signed_15(0), 15), y = part_of(half_size.y, chance.signed_15(1), 15);
    const std::uint32_t phase_16 = phase >> 16;
    const auto half_height = convert<WorldWide>(half_size.z), height = half_height * 2;
    if (phase_16 < kFall_16) return {x, y, convert<World>(half_height - height * phase_16 / kFall_16)};
    const std::int64_t age_13 = phase_16 - kFall_16;
    const auto inward = [age_13](World place, World half) {
        const World way = part_of(std::min(half, World::from_int(2)), age_13, 13);
        return place > World{} ? place - way : place + way;
    };
    const std::int64_t hop_24 = age_13 * (8192 - age_13);
    const World most_hop = convert<World>(std::min(height, WorldWide::from_int(3)));
    return {inward(x, half_size.x), inward(y, half_size.y), part_of(most_hop, hop_24, 24) - half_size.z};
}

Vec3<World> dust_at(const Vec3<World>& half_size, const Chance& chance, std::uint32_t phase) {
    const auto drift = [&](World half, int which, std::uint32_t at) {
        const World swing = swing_in(half, World::from_int(16));
        return place_along(half, swing, chance.signed_15(which)) + wave(swing, at);
    };
    const auto other = static_cast<std::uint32_t>(chance.share_16(0)) << 16;
    return {drift(half_size.x, 0, phase), drift(half_size.y, 1, phase + other), drift(half_size.z, 2, phase * 2)};
}

/// With the age s from 0 to 1, it moves sideways at constant speed, and its height is v s - (v + 1) s^2, in half
/// heights of the box: -1 at the end, and at most v^2 / (4 v + 4), which is 4/5 or less for v from 0 to 4.
Vec3<World> spark_at(const Vec3<World>& half_size, const Chance& chance, std::uint32_t phase) {
    const std::int64_t age_16 = phase >> 16;
    const auto sideways = [&](World half, int which) { return part_of(half, chance.signed_15(which) * age_16, 31); };
    const std::int64_t speed_14 = chance.share_16(2), fall_14 = speed_14 + (1 << 14);
    const std::int64_t height_30 = speed_14 * age_16 - floor_shift(fall_14 * age_16 * age_16, 16);
    return {sideways(half_size.x, 0), sideways(half_size.y, 1), part_of(half_size.z, height_30, 30)};
}

Vec3<World> bubble_at(const Vec3<World>& half_size, const Chance& chance, std::uint32_t phase) {
    const auto wobble = [&](World half, int which, std::uint32_t at) {
        const World swing = swing_in(half, World::from_int(2));
        return place_along(half, swing, chance.signed_15(which)) + wave(swing, at);
    };
    const std::int64_t height_15 = static_cast<std::int64_t>(phase >> 16) - 32768;
    return {wobble(half_size.x, 0, phase * 4), wobble(half_size.y, 1, phase * 4 + (1u << 30)),
            part_of(half_size.z, height_15, 15)};
}

std::uint8_t colour_of(const ParticleEmitter& emitter, std::int32_t share_16) {
    const std::int32_t ramp = emitter.last_colour - emitter.first_colour, count = (ramp < 0 ? -ramp : ramp) + 1;
    const std::int32_t step = floor_shift(count * share_16, 16);
    return static_cast<std::uint8_t>(emitter.first_colour + (ramp < 0 ? -step : step));
}

Vec3<World> place_in_box(const ParticleEmitter& emitter, const Chance& chance, std::uint32_t phase) {
    switch (emitter.kind) {
        case ParticleKind::Rain:
            return rain_at(emitter.half_size, chance, phase);
        case ParticleKind::Dust:
            return dust_at(emitter.half_size, chance, phase);
        case ParticleKind::Sparks:
            return spark_at(emitter.half_size, chance, phase);
        case ParticleKind::Bubbles:
            break;
    }
    return bubble_at(emitter.half_size, chance, phase);
}

}  // namespace

std::uint32_t phase_at(const ParticleEmitter& emitter, std::int64_t time_ms) {
    const std::int64_t rest_ms = time_ms % emitter.period_ms;
    return static_cast<std::uint32_t>(rest_ms * (std::int64_t{1} << 32) / emitter.period_ms);
}

Particle particle_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase) {
    const Chance chance(emitter.seed, index);
    const std::uint32_t own_phase = phase + chance.phase();
    const auto age_16 = static_cast<std::int32_t>(own_phase >> 16);
    const bool is_spark = emitter.kind == ParticleKind::Sparks;
    Particle particle;
    particle.position = emitter.middle + place_in_box(emitter, chance, own_phase);
    particle.colour = colour_of(emitter, is_spark ? age_16 : chance.share_16(3));
    particle.is_streak = emitter.kind == ParticleKind::Rain && age_16 < 7 * 8192;
    return particle;
}

}  // namespace oblong
