#pragma once

#include <optional>

#include "engine/geometry/view_context.h"
#include "engine/level/level.h"
#include "engine/screen/screen.h"

namespace oblong {

/// A rectangle of pixels outside of which nothing in a box of the level is drawn, a pixel wider than it need be for
/// what rounds on the way. Nothing if the box reaches the eye's plane or nearly: then it may be anywhere.
std::optional<ScreenRectangle> rectangle_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
