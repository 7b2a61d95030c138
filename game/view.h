#pragma once

#include <vector>

#include "engine/frame/frame.h"
#include "engine/geometry/camera.h"
#include "game/live_input.h"
#include "game/stage.h"

namespace oblong {

/// Two states one tick apart and how far the picture is between them: 0 is the first, 65,536 the second.
struct Moment {
    const GameState& before;
    const GameState& after;
    std::int32_t fraction_16 = 0;
};

/// The player's eye at a moment, turned further by `lead`.
Camera camera_at(const Moment& moment, ViewLead lead, Degrees field_of_view);

/// Every mover at its place at a moment, and the level's other brush models at theirs; models of triggers are not seen.
std::vector<PlacedModel> models_at(const Stage& stage, const Moment& moment);

/// The time of a moment since the level began.
std::int64_t time_ms_at(const Moment& moment);

}  // namespace oblong
