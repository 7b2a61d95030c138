#pragma once

#include <cstdint>
#include <optional>

#include "engine/view/clip_line.h"

namespace oblong {

/// Two bits beside those of Outcode for the sides.
inline constexpr unsigned kOutFront = 16, kOutBack = 32;

/// A bit for each plane of the volume that a point in viewspace is outside of; a point on a plane is inside.
unsigned outcode_of(const ViewVolume& volume, const Vec3<View>& p);

enum class LineClipping : std::uint8_t {
    CohenSutherland,  ///< an outcode for each end; the line is cut at one plane after the other, and rounded at each
    LiangBarsky       ///< clip_line() of engine/view
};

/// The part of a line in the volume; none if there is none. Cohen and Sutherland: Newman and Sproull, "Principles of
/// Interactive Computer Graphics".
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line, LineClipping method);

}  // namespace oblong
