#pragma once

#include <vector>

#include "engine/frame/frame.h"

namespace oblong {

/// The brush models that a level's entities show, where they stand when it begins. Triggers are not shown. An entity
/// that names a model that the level hasn't is passed over.
std::vector<PlacedModel> models_at_rest(const Level& level);

}  // namespace oblong
