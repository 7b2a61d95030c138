#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"
#include "engine/view/views.h"
#include "game/options/preferences.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// The view drawn instead of the camera's, if a key asks for one. Isometric: from the south-west, the player in the
/// middle, without the level above. Zoomed: another field of view, with the eye moved so that the object in the middle
/// keeps its size; a front plane through the player cuts off what the eye has backed into. `zoom_degrees`: 0: none.
std::optional<ViewSpec> other_view(bool is_isometric, std::int32_t zoom_degrees, const Camera& camera,
                                   const Level& level);

/// Moves and leans the camera in walking, as Quake does, but in integers. Depends only on the states and the fraction
/// between them. The eye goes up and down once in 0.6 s, by at most 0.02 s times the speed, between 7 units below and 4
/// above its place; the view leans by 2 degrees at 200 units a second sideways, and no further. Both are multiplied by
/// their preferences.
void sway(const InterpolatedState& state, const ComfortPreferences& preferences, Camera& camera);

}  // namespace oblong
