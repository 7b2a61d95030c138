#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "engine/raster/depth.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

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

/// A box of places, and which of its 4 x 4 columns, seen from above, count: a bit each, from the least x and y.
struct ParticleBox {
    static constexpr int kColumns = 16;

    Vec3<World> mins, maxs;
    std::uint32_t columns = (1u << kColumns) - 1;

    bool holds(World x, World y) const {
        if (x < mins.x || x > maxs.x || y < mins.y || y > maxs.y) return false;
        return (columns >> (quarter_of(x, mins.x, maxs.x) + 4 * quarter_of(y, mins.y, maxs.y)) & 1) != 0;
    }
    /// The borders of a column.
    ParticleBox column(int number) const {
        const auto border = [](World low, World high, int quarter) {
            return quarter == 4 ? high : low + (high - low) / 4 * quarter;
        };
        const int x = number % 4, y = number / 4;
        return {{border(mins.x, maxs.x, x), border(mins.y, maxs.y, y), mins.z},
                {border(mins.x, maxs.x, x + 1), border(mins.y, maxs.y, y + 1), maxs.z}};
    }

  private:
    static int quarter_of(World place, World low, World high) {
        const World quarter = (high - low) / 4, beyond = place - low;
        return (beyond > quarter) + (beyond > quarter * 2) + (beyond > quarter * 3);
    }
};

/// The box that an emitter's particles never leave.
inline ParticleBox box_of(const ParticleEmitter& emitter) {
    return {emitter.middle - emitter.half_size, emitter.middle + emitter.half_size};
}

/// Particle `index` (0 to count - 1) at a phase, if it is in a box. A closed formula, so that particles out of view
/// cost nothing.
std::optional<Particle> particle_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase,
                                    const ParticleBox& within);

/// A particle on the screen: a block of pixels at one depth, inside the screen and not empty.
struct ParticleDot {
    std::int16_t first_column, end_column, first_row, end_row;
    InverseDepth inverse_depth;
    std::uint8_t colour;
};

/// Appends the dots of an emitter's particles in view, hidden or not, that are in a box.
/// Particles nearer than 16 units are left out. A dot is at least one pixel wide and high, and at most 1/16 of the
/// screen wide and 1/4 high. The camera's field of view is 1 to 179 degrees. Returns how many particles are in the box.
std::int32_t append_dots(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view,
                         const ParticleBox& within, std::vector<ParticleDot>& dots);

/// The bounding rectangle of dots; empty if there are none.
ScreenRectangle rectangle_around(std::span<const ParticleDot> dots);

/// Draws dots, in any order, where nothing is nearer. `depth` must be valid at their pixels (DepthBuffer::want).
void draw_dots(std::span<const ParticleDot> dots, DepthBuffer& depth, Framebuffer out);

}  // namespace oblong
