#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "engine/effects/entity_values.h"
#include "engine/files/level_models.h"

namespace oblong {

/// Reads the entities of a level whose brushes turn, func_rotating and func_door_rotating, as models. What it warns of
/// is left out or turns about its middle.
class TurningBrushes {
  public:
    /// A model and its mesh, which is appended; nothing where the entity has no brushes, or they are left out.
    std::optional<LevelModel> read(const Level& level, const Entity& entity, const EntityValues& values,
                                   std::vector<std::unique_ptr<const Mesh>>& meshes);

  private:
    std::set<ModelIndex> read_;                         // each turns once
    std::int64_t texels_left_ = std::int64_t{1} << 25;  // of all their skins
};

}  // namespace oblong
