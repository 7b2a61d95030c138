#pragma once

#include "game/options/preferences.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// Moves and leans the camera as a walk does: as in Quake, but in integers. A pure function of the states and of how
/// far the picture is between them. The eye goes up and down once in 0.6 s, by at most 0.02 s times the speed, between
/// 7 units below and 4 above its place; the view leans by 2 degrees at 200 units a second sideways, and no further.
/// Each times its preference.
void sway(const InterpolatedState& state, const Preferences& preferences, Camera& camera);

}  // namespace oblong
