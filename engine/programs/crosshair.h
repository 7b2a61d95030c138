#pragma once

#include <span>
#include <string>

#include "engine/draw/drawing.h"
#include "engine/scene/pick.h"
#include "engine/view/projection.h"

namespace oblong {

/// The first face on the camera's middle ray.
std::optional<PickedFace> pick_ahead(const Level& level, std::span<const PlacedModel> models, const Camera& camera);

/// A description of a picked face, in two lines: texture, distance and place; face, plane and entity. "Nothing ahead"
/// for none.
std::string describe_picked(const Level& level, std::span<const PlacedModel> models,
                            const std::optional<PickedFace>& picked);

/// Draws a cross around the middle of the canvas, which stays free.
void draw_crosshair(Framebuffer canvas, TextColours colours);

}  // namespace oblong
