#pragma once

#include <cstdint>

namespace oblong {

/// Pixels: columns [first_column, end_column) of rows [first_row, end_row); within the screen, perhaps empty.
struct ScreenRectangle {
    std::int32_t first_column, end_column, first_row, end_row;
};

}  // namespace oblong
