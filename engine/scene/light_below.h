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

}  // namespace oblong
