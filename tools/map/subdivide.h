#pragma once

#include "tools/map/surfaces.h"

namespace oblong::map {

/// Texels that a lit surface may reach across, as counted in whole steps of 16: a lightmap has at most 16 x 16 samples.
inline constexpr int kMaxExtent = 240;

/// Cuts lit surfaces so that none exceeds kMaxExtent. Throws InputError if that makes more than a level can have.
std::vector<Surface> subdivided(std::vector<Surface> surfaces, const std::vector<TexInfo>& texinfos);

}  // namespace oblong::map
