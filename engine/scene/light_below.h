#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"
#include "engine/scene/light_styles.h"

namespace oblong {

/// The light on the nearest lit face of the world straight below a point: the lightmap's sample that holds the place,
/// by the brightness of the face's styles; a lightmap value, 8 fraction bits. What stands there is lit as its floor is
/// (Quake's R_LightPoint). None where no lit face is below, or the level has no light.
std::optional<std::int32_t> light_8_below(const Level& level, const Vec3<World>& from, const LightStyles& styles);

/// The light of the sample that holds a texel of a lit face, counted from the surface's first one: from 0 to its
/// extents.
std::int32_t light_8_of_sample(const Level& level, const Face& face, std::int64_t u, std::int64_t v,
                               const LightStyles& styles);

}  // namespace oblong
