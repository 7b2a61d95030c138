#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// How particles move and look.
enum class ParticleKind : std::uint8_t {
    Rain,    ///< falls from the top of the box to its bottom, and ends in a splash
    Dust,    ///< drifts around its place
    Sparks,  ///< fly on parabolas from the middle of the box to its bottom
    Bubbles  ///< rise from the bottom of the box to its top, and wobble
};

/// Particles of one kind, which never leave their box.
struct ParticleEmitter {
    ParticleKind kind = ParticleKind::Rain;
    Vec3<World> middle;     ///< of the box
    Vec3<World> half_size;  ///< from the middle to the sides; >= 0
    std::int32_t count = 0;
    std::uint8_t first_colour = 0, last_colour = 0;  ///< a ramp of the palette, by a spark's age, otherwise random
    std::int32_t period_ms = 1000;                   ///< of the motion, > 0
    std::uint32_t seed = 0;                          ///< of all random numbers
};

struct Particle {
    Vec3<World> position;
    std::uint8_t colour = 0;
    bool is_streak = false;  ///< a falling drop of rain
};

/// The phase of an emitter at time_ms >= 0: 2^32 to the period, so that sums wrap.
std::uint32_t phase_at(const ParticleEmitter& emitter, std::int64_t time_ms);

/// Particle `index` (0 to count - 1) at a phase. A closed formula, so that particles out of view cost nothing.
Particle particle_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase);

}  // namespace oblong
