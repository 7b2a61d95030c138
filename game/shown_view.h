#pragma once

#include <optional>

#include "engine/level/level.h"
#include "engine/view/views.h"
#include "game/view_options.h"

namespace oblong {

/// The view that is drawn instead of the camera's, if a key asks for one. Isometric: from the south-west, the player in
/// the middle, without what is above. Zoomed: another field of view, and the eye moved so that what is in the middle
/// keeps its size; what the eye has backed into is cut off by a front plane through the player.
std::optional<ViewSpec> other_view(const ViewOptions& options, const Camera& camera, const Level& level);

}  // namespace oblong
