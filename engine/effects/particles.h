#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// How particles move and look.
enum class ParticleKind : std::uint8_t {
    Rain,    ///< falls straight from the top of the box to its bottom, and ends in a splash
    Dust,    ///< drifts about its place
    Sparks,  ///< fly from the middle of the box on parabolas that end at its bottom
    Bubbles  ///< rise from the bottom of the box to its top, and wobble
};

/// Particles of one kind in a box. They never leave it.
struct ParticleEmitter {
    ParticleKind kind = ParticleKind::Rain;
    Vec3<World> middle;     ///< of the box
    Vec3<World> half_size;  ///< from its middle to its sides; 0 and more
    std::int32_t count = 0;
    std::uint8_t first_colour = 0, last_colour = 0;  ///< a ramp of the palette: of a spark's age, else by chance
    std::int32_t period_ms = 1000;                   ///< above 0: when everything returns
    std::uint32_t seed = 0;                          ///< others: other places
};

struct Particle {
    Vec3<World> position;
    std::uint8_t colour = 0;
    bool is_streak = false;  ///< a falling drop of rain
};

/// How far through its period an emitter is at a time of 0 and more: 2^32 to the period, so that sums wrap by
/// themselves.
std::uint32_t phase_at(const ParticleEmitter& emitter, std::int64_t time_ms);

/// Particle `index` (0 to count - 1) at a phase: a closed formula, so that particles out of sight cost nothing and need
/// not catch up.
Particle particle_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase);

}  // namespace oblong
