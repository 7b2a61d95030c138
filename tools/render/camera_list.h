#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/view/projection.h"
#include "engine/view/views.h"

namespace oblong {

/// Cameras from the text of a CSV file. Its first line names the columns: x, y, z, yaw, pitch and perhaps roll, in any
/// order (world units within +-32,768, degrees, pitch positive looking down). Throws InputError that names the line.
std::vector<Camera> parse_cameras(std::span<const std::uint8_t> bytes, Degrees field_of_view);

/// The view of a camera; most views are centred on the camera's position.
using ViewOfCamera = std::function<ViewSpec(const Camera&)>;

/// The names and keys of views for --help and messages.
extern const char* const kViewSyntax;

/// "NAME" or "NAME:KEY=VALUE,...". Throws UsageError that says which name, key or value is wrong.
ViewOfCamera parse_view(const std::string& text);

/// The view of a camera. Throws UsageError that begins with `where` if it cannot be drawn in the mode.
ViewSpec checked_view(const ViewOfCamera& view, const Camera& camera, const ScreenMode& mode, const std::string& where);

}  // namespace oblong
