#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/lit_surface.h"

namespace oblong {

/// A texel's colour in light of three channels, each 0 to twice kFullLight with 8 fraction bits, not dithered;
/// fullbright colours are as they are.
std::uint8_t coloured_texel(const ColourCube& cube, std::uint8_t texel, const std::array<std::int32_t, 3>& light_8);

/// As build_lit_surface(), with the light's red, green and blue instead of its luminance: each is interpolated, and its
/// product with the texel's is rounded to the nearest level, or dithered. `corners` is scratch of
/// three entries a sample. LightmapView::added_8 is white.
void build_coloured_surface(const TextureView& texture, const LightmapView& light, const LightTables& tables,
                            const LightQuality& quality, int mip, std::int32_t stride, std::int32_t* corners,
                            std::uint8_t* out);

}  // namespace oblong
