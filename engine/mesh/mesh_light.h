#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/mesh/placed_mesh.h"
#include "engine/scene/moving_lights.h"
#include "engine/surface/lit_surface.h"

namespace oblong {

/// Light from the same direction everywhere.
struct DirectionalLight {
    Vec3<Unit> toward;          ///< to the light, of length 1
    std::int32_t strength = 0;  ///< a lightmap value, 0 to kMostLight: the light on a surface that faces it
};

/// The light on a mesh. kFullLight shows a skin's colours unchanged.
struct MeshLight {
    std::int32_t ambient = kFullLight;  ///< a lightmap value, 0 to kMostLight
    DirectionalLight directional;
    std::span<const MovingLight> points = {};
    std::int32_t brightness_100 = 100;  ///< of the sum

    static constexpr std::int32_t kMostLight = 4096;
};

/// A lightmap value with 8 fraction bits.
using Light8 = std::int32_t;

/// strength max(0, N . L): Lambert's law, L the direction to the light; N and L have length 1.
Light8 diffuse_light(const Vec3<Unit>& normal, const DirectionalLight& light);
/// The same for a light at a point: full at the light, falling linearly to 0 at its radius (as in Quake).
Light8 diffuse_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MovingLight& light);
/// The part interpolated with Shading::Phong: ambient light and point lights.
Light8 ambient_and_point_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light);
/// All light on a vertex.
Light8 light_at(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light);

/// Blinn's highlight: brightest (N . H)^kShininess, indexed by 256 N . H from 0 to 256. H is halfway between the
/// directions to the light and to the eye.
using HighlightTable = std::array<Light8, 257>;
inline constexpr int kShininess = 16;
HighlightTable make_highlight_table(std::int32_t brightest);
Vec3<Unit> halfway(const Vec3<Unit>& toward_light, const Vec3<Unit>& toward_eye);

}  // namespace oblong
