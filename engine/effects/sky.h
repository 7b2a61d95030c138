#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/projection.h"
#include "engine/math/basis.h"
#include "engine/screen/screen.h"

namespace oblong {

/// A sky of two layers side by side in one texture: the right half is the background, the left half clouds in front of
/// it, whose colour 0 is transparent. Each half is square, of a power of two.
struct SkyTexture {
    const std::uint8_t* texels = nullptr;
    std::int32_t size = 0;    ///< of a half, texels, in both directions
    std::int32_t stride = 0;  ///< bytes from row to row of the whole texture
};

/// Draws a dome: a texel depends on the direction of view alone, with heights tripled as Quake does, for a flat dome.
/// Directions are computed every 8 pixels and interpolated between.
void draw_sky(std::span<const Span> spans, const SkyTexture& sky, const Basis& axes, const Projection& projection,
              Framebuffer out);

}  // namespace oblong
