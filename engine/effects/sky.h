#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/projection.h"
#include "engine/math/basis.h"
#include "engine/screen/screen.h"

namespace oblong {

/// A sky of two layers side by side in one texture: the right half is the background, the left half clouds in front of
/// it, whose colour 0 is transparent. Each half is square, of a power of two up to 32,768.
struct SkyTexture {
    const std::uint8_t* texels = nullptr;
    std::int32_t size = 0;    ///< of a half, texels, in both directions
    std::int32_t stride = 0;  ///< bytes from row to row of the whole texture
};

/// After so long both layers are where they began: the background has moved once round, the clouds twice. As in Quake,
/// that is 8 and 16 texels a second of a sky of 128.
inline constexpr std::int64_t kSkyPeriod_ms = 16'000;

/// Draws a dome: a texel depends on the direction of view alone, with heights tripled as Quake does, for a flat dome.
/// Directions are computed every 8 columns and interpolated between. Both layers move along both axes; the background
/// moves evenly, the clouds by one more texel whenever it has moved by a whole one. `time_ms` is 0 or more. `layers` is
/// scratch, and is not touched by a sky that has many more texels than pixels.
void draw_sky(std::span<const Span> spans, const SkyTexture& sky, const Basis& axes, const Projection& projection,
              std::int64_t time_ms, std::vector<std::uint8_t>& layers, Framebuffer out);

/// How much draw_sky() has to do for these spans.
struct SkyWork {
    std::int64_t directions = 0;       ///< computed: one more a span than it has blocks
    std::int64_t composed_texels = 0;  ///< of both layers as one; 0: both are looked up at each pixel
};
/// `size` is the sky texture's.
SkyWork work_of_sky(std::span<const Span> spans, std::int32_t size, const Basis& axes, const Projection& projection);

}  // namespace oblong
