#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/effects/particles.h"
#include "engine/raster/depth.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A particle on the screen: a block of pixels at one depth, inside the screen and not empty.
struct ParticleDot {
    std::int16_t first_column, end_column, first_row, end_row;
    InverseDepth inverse_depth;
    std::uint8_t colour;
};

/// Appends the dots of an emitter's particles in view, hidden or not. Particles nearer than 16 units are left out. A
/// dot is at least one pixel wide and high, and at most 1/16 of the screen wide and 1/4 high. The camera's field of
/// view is 1 to 179 degrees.
void append_dots(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view,
                 std::vector<ParticleDot>& dots);

/// The bounding rectangle of dots; empty if there are none.
ScreenRectangle rectangle_around(std::span<const ParticleDot> dots);

/// Draws dots, in any order, where nothing is nearer. `depth` must be valid at their pixels (DepthBuffer::want).
void draw_dots(std::span<const ParticleDot> dots, DepthBuffer& depth, Framebuffer out);

}  // namespace oblong
