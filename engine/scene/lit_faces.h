#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/level/level.h"
#include "engine/surface/lit_surface.h"
#include "engine/surface/surface_cache.h"

namespace oblong {

/// Brightness of the 64 light styles, 256: as stored in the lightmaps.
using LightStyles = std::array<std::uint16_t, 64>;

/// Samples of a face's lightmap, of one style.
std::size_t light_sample_count(const Face& face);
/// Bytes of a face's lit surface at a mip level, rows a power of two apart.
std::size_t surface_bytes(const Face& face, int mip);

/// A face's lit surface at a mip level, from the cache or built now. Its texels are good until the cache's next get().
/// `corner_shades` is scratch of light_sample_count() entries.
SurfaceView lit_surface_of(const Level& level, FaceIndex index, int mip, const Colormap& colormap,
                           const LightStyles& styles, SurfaceCache& cache, std::vector<std::int32_t>& corner_shades);

}  // namespace oblong
