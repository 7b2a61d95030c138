#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/mesh/placed_mesh.h"
#include "engine/scene/moving_lights.h"
#include "engine/surface/lit_surface.h"

namespace oblong {

/// Light that comes from one direction everywhere.
struct DirectionalLight {
    Vec3<Unit> toward;          ///< from the surface to the light, of length 1
    std::int32_t strength = 0;  ///< a lightmap value: what a surface that faces it gets; 0 to kMostLight
};

/// The light that falls on a mesh. kFullLight shows a skin's own colours.
struct MeshLight {
    std::int32_t ambient = kFullLight;  ///< a lightmap value, 0 to kMostLight: from everywhere
    DirectionalLight directional;
    std::span<const MovingLight> points = {};  ///< each reaches as far as its radius
    std::int32_t brightness_100 = 100;         ///< of all of it

    static constexpr std::int32_t kMostLight = 4096;
};

/// A lightmap value with 8 fraction bits.
using Light8 = std::int32_t;

/// strength max(0, N . L): Lambert's law, L the direction to the light. Both of length 1.
Light8 diffuse_light(const Vec3<Unit>& normal, const DirectionalLight& light);
/// The same from a place: full at the light, nothing from its radius on, linear between (Quake's).
Light8 diffuse_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MovingLight& light);
/// What does not depend on a pixel's normal of Shading::Phong: ambient light, and that of points.
Light8 even_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light);
/// All light that a vertex gets.
Light8 light_at(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light);

/// A row of Colormap, with 16 fraction bits, for the light that a pixel gets.
std::int32_t shade_16_of(Light8 light, std::int32_t brightness_100);

/// Blinn's highlight: (N . H)^kShininess by N . H of 0 to 1 in 256ths, times the light that it adds where it is
/// brightest. H is halfway between the directions to the light and to the eye.
using HighlightTable = std::array<Light8, 257>;
inline constexpr int kShininess = 16;
HighlightTable make_highlight_table(std::int32_t brightest);
Vec3<Unit> halfway(const Vec3<Unit>& toward_light, const Vec3<Unit>& toward_eye);

}  // namespace oblong
