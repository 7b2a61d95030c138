#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/basis.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// A sky of two layers side by side in one texture: the right half is the background, the left half clouds in front of
/// it, whose colour 0 is transparent. Each half is square, of a power of two up to 32,768.
struct SkyTexture {
    const std::uint8_t* texels = nullptr;
    std::int32_t size = 0;    ///< of a half, texels, in both directions
    std::int32_t stride = 0;  ///< bytes from row to row of the whole texture
    bool operator==(const SkyTexture&) const = default;
};

/// After so long both layers are where they began: the background has moved once round, the clouds twice. As in Quake,
/// that is 8 and 16 texels a second of a sky of 128.
inline constexpr std::int64_t kSkyPeriod_ms = 16'000;

/// A sky at one time.
struct SkyNow {
    SkyTexture texture;
    std::int64_t time_ms;                ///< 0 or more
    std::span<const std::uint8_t> tile;  ///< both layers as one; empty: they are looked up at each pixel
};

/// Both layers of a sky as one: kept while neither moves against the other, for an eighth of a second of a sky of 128.
struct SkyLayers {
    SkyTexture texture;               ///< that the layers are of; empty: none yet
    std::int32_t clouds_further = 0;  ///< whole texels
    std::vector<std::uint8_t> tile;
};

/// Lays both layers of a sky that covers so many pixels over each other, if it has not many more texels than that, or
/// they are in `layers`, which lasts as long as what is returned.
SkyNow compose_sky(const SkyTexture& texture, std::int64_t time_ms, std::int64_t pixels, SkyLayers& layers);

/// Draws a dome: a texel depends on the direction of view alone, with heights tripled as Quake does, for a flat dome.
/// Directions are computed every 8 to 64 columns, by the row, and interpolated between: within a texel of a 128-texel
/// sky wherever 8 columns are. Both layers move along both axes; the background moves evenly, the clouds by one more
/// texel whenever it has moved by a whole one. Returns how many blocks it drew: it computes one more direction a span.
std::int64_t draw_sky(std::span<const Span> spans, const SkyNow& sky, const Basis& axes, const Projection& projection,
                      Framebuffer out);

}  // namespace oblong
