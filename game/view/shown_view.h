#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"
#include "engine/view/views.h"

namespace oblong {

/// The view that is drawn instead of the camera's, if a key asks for one. Isometric: from the south-west, the player in
/// the middle, without what is above. Zoomed: another field of view, and the eye moved so that what is in the middle
/// keeps its size; what the eye has backed into is cut off by a front plane through the player. `zoom_degrees`: 0:
/// none.
std::optional<ViewSpec> other_view(bool is_isometric, std::int32_t zoom_degrees, const Camera& camera,
                                   const Level& level);

}  // namespace oblong
