#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "engine/effects/entity_values.h"
#include "engine/level/level.h"
#include "engine/mesh/mesh.h"
#include "engine/models/level_models.h"

namespace oblong {

/// Whether all of a brush model is nearer than kMeshLimit to a point along each axis.
bool is_within_mesh(const SubModel& model, const Vec3<World>& about);

/// The faces of a brush model as a mesh about the point `about` (is_within_mesh), so that it can turn. Each face has a
/// skin of its unlit texels, and shares no vertices, so that it is lit on its own. Texels beyond kMostTexel in a
/// direction repeat the last one. Animated textures show their first frame. Skins are counted off `texels_left`; a face
/// for which too few are left gets one colour.
Mesh make_brush_mesh(const Level& level, ModelIndex model, const Vec3<World>& about, std::int64_t& texels_left);

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
