#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/effects/particles.h"
#include "engine/raster/depth.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A particle on the screen: a block of pixels, within the screen and not empty, at one depth.
struct ParticleDot {
    std::int16_t first_column, end_column, first_row, end_row;
    InverseDepth inverse_depth;
    std::uint8_t colour;
};

/// Appends the dots of those of an emitter's particles that are in view, whether or not something hides them. None is
/// nearer than 16 units or less than a pixel in either direction, or more than 1/16 of the screen wide or 1/4 high.
/// The camera's field of view is 1 to 179 degrees.
void append_dots(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view,
                 std::vector<ParticleDot>& dots);

/// The rectangle around dots; empty without any.
ScreenRectangle rectangle_around(std::span<const ParticleDot> dots);

/// Draws dots where nothing nearer has been drawn, in any order. The depth of their pixels must be wanted.
void draw_dots(std::span<const ParticleDot> dots, DepthBuffer& depth, Framebuffer out);

}  // namespace oblong
