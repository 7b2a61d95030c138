#pragma once

#include <span>
#include <string>

#include "engine/draw/text.h"
#include "engine/scene/pick.h"
#include "engine/view/projection.h"

namespace oblong {

/// What a camera's middle ray meets first.
std::optional<PickedFace> pick_ahead(const Level& level, std::span<const PlacedModel> models, const Camera& camera);

/// What a picked face is, in two lines: texture, distance and place; face, plane and entity. "Nothing ahead" for none.
std::string describe_picked(const Level& level, std::span<const PlacedModel> models,
                            const std::optional<PickedFace>& picked);

/// A cross around the middle of the canvas, which it leaves free.
void draw_crosshair(Framebuffer canvas, TextColours colours);

}  // namespace oblong
