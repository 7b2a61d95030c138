#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/view/projection.h"

namespace oblong {

/// Cameras from the text of a CSV file. Its first line names the columns: x, y, z, yaw, pitch and perhaps roll, in any
/// order (world units within +-32,768, degrees, pitch positive looking down). Throws InputError that names the line.
std::vector<Camera> parse_cameras(std::span<const std::uint8_t> bytes, Degrees field_of_view);

}  // namespace oblong
