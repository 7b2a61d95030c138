#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// Pixels of a rectangle whose sums and differences of column and row are within limits: an octagon.
struct ScreenOutline {
    static constexpr std::int32_t kUnlimited = 1 << 30;

    ScreenRectangle pixels;
    PixelRange sums{-kUnlimited, kUnlimited}, differences{-kUnlimited, kUnlimited};

    /// The part of a row's columns [first, end) that is inside; perhaps empty.
    PixelRange columns_in(std::int32_t row, std::int32_t first, std::int32_t end) const {
        return {std::max({first, pixels.first_column, sums.first - row, differences.first + row}),
                std::min({end, pixels.end_column, sums.end - row, differences.end + row})};
    }
};

/// A box in viewspace that may be turned: its middle, and the ways from there to the middles of three faces.
struct ViewBox {
    Vec3<View> middle;
    std::array<Vec3<View>, 3> arms;

    View nearest_z() const { return middle.z - absolute(arms[0].z) - absolute(arms[1].z) - absolute(arms[2].z); }
};

/// Nearer than this, rounding moves a point by more than a pixel.
inline constexpr View kExactFrom = View::from_int(4);

/// Holds every pixel where something in the box may be drawn, a pixel more for rounding. The whole screen if a part of
/// the box is nearer than kExactFrom.
ScreenOutline outline_of(const ViewBox& box, const Projection& projection);

}  // namespace oblong
