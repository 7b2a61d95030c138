#pragma once

#include <string>
#include <vector>

#include "tools/demo_level/art/textures.h"

namespace oblong::model_source {

/// An armillary sphere: a celestial globe in rings of brass, on a turned foot. Its outermost ring has the radius 1, the
/// foot stands on y = 0.
std::string armillary_obj();
std::string armillary_mtl();
std::vector<art::NamedCanvas> paint_armillary();  ///< its skins

}  // namespace oblong::model_source
