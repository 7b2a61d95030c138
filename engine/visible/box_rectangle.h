#pragma once

#include <optional>

#include "engine/visible/vertex_cache.h"

namespace oblong {

/// Pixels: columns [first_column, end_column) of rows [first_row, end_row); within the screen, perhaps empty.
struct ScreenRectangle {
    std::int32_t first_column, end_column, first_row, end_row;
};

/// A rectangle of pixels outside of which nothing in a box of the level is drawn, a pixel wider than it need be for
/// what rounds on the way. Nothing if the box reaches the eye's plane or nearly: then it may be anywhere.
std::optional<ScreenRectangle> rectangle_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
