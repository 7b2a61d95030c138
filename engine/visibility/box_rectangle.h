#pragma once

#include <optional>

#include "engine/level/level.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A rectangle that holds every pixel where something in a box of the level may be drawn, conservative by one pixel for
/// rounding. None if the box reaches the eye's plane or nearly: it may then be anywhere on the screen.
std::optional<ScreenRectangle> rectangle_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
