#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "engine/effects/entity_values.h"
#include "engine/files/level_models.h"

namespace oblong {

/// Reads entities with turning brushes, func_rotating and func_door_rotating, as models. It warns of entities that are
/// left out or turn about their middle.
class TurningBrushes {
  public:
    /// A model and its mesh, which is appended; nothing if the entity has no brushes, or is left out.
    std::optional<LevelModel> read(const Level& level, const Entity& entity, const EntityValues& values,
                                   std::vector<std::unique_ptr<const Mesh>>& meshes);

  private:
    std::set<ModelIndex> read_;                         // each is read once
    std::int64_t texels_left_ = std::int64_t{1} << 25;  // of all their skins
};

}  // namespace oblong
