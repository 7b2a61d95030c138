#pragma once

#include <cstdint>

#include "engine/mesh/mesh.h"

namespace oblong {

/// Squares of 8 texels in two colours, `size` texels a side.
Skin checkered_skin(std::int32_t size, std::uint8_t one, std::uint8_t other);
/// One texel.
Skin plain_skin(std::uint8_t colour);

/// A ball around the origin: `rings` from pole to pole, twice as many sectors around. The skin goes around once.
Mesh ball_mesh(double radius, int rings, Skin skin);

/// A cube around the origin, each side with the whole skin and normals of its own.
Mesh cube_mesh(double half_size, Skin skin);

}  // namespace oblong
