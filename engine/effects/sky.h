#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/basis.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// A sky of two layers side by side in one texture: the right half is the background, the left half the clouds, whose
/// colour 0 is transparent. Each half is square; its size is a power of two up to 32,768.
struct SkyTexture {
    const std::uint8_t* texels = nullptr;
    std::int32_t size = 0;    ///< width and height of a half, texels
    std::int32_t stride = 0;  ///< bytes from row to row
    bool operator==(const SkyTexture&) const = default;
};

/// Whether a texture of these sizes is such a sky; any other is drawn as one colour.
constexpr bool is_layered_sky(std::int32_t width, std::int32_t height) {
    return width == 2 * height && (height & (height - 1)) == 0;
}

/// The layers' period: the background has moved once round, the clouds twice. As in Quake, that is 8 and 16 texels a
/// second for a sky of 128 texels.
inline constexpr std::int64_t kSkyPeriod_ms = 16'000;

/// A sky at one time.
struct SkyNow {
    SkyTexture texture;
    std::int64_t time_ms;                ///< >= 0
    std::span<const std::uint8_t> tile;  ///< both layers combined; empty: look up both at each pixel
};

/// Both layers of a sky combined; kept until one moves against the other, an eighth of a second for a sky of 128
/// texels.
struct SkyLayers {
    SkyTexture texture;               ///< of the layers; empty: none yet
    std::int32_t clouds_further = 0;  ///< whole texels
    std::vector<std::uint8_t> tile;
};

/// Combines both layers of a sky, unless it has many more texels than the `pixels` that it covers and they are not in
/// `layers` yet. `layers` must outlive the result.
SkyNow compose_sky(const SkyTexture& texture, std::int64_t time_ms, std::int64_t pixels, SkyLayers& layers);

/// Draws a dome: a texel depends on the direction of view only; heights are tripled as in Quake, for a flat dome.
/// Texels are computed every 8 to 64 columns, depending on the row, and interpolated between; the error is below a
/// texel of a 128-texel sky except perhaps in cells of 8 columns. Both layers move along both axes: the background
/// smoothly, the clouds by one more texel for each whole texel that it moves. Returns the number of blocks; one more
/// direction is computed for each span.
std::int64_t draw_sky(std::span<const Span> spans, const SkyNow& sky, const Basis& axes, const Projection& projection,
                      Framebuffer out, BlockKernel draw_blocks);

}  // namespace oblong
