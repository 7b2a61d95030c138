#pragma once

#include "engine/level/level.h"
#include "engine/mesh/mesh.h"

namespace oblong {

/// Whether a brush model is less than kMeshLimit away from a point in all directions.
bool is_within_mesh(const SubModel& model, const Vec3<World>& about);

/// The faces of a brush model as a mesh about such a point of the level, so that it can turn: each with a skin of the
/// texels that lie on it, without light, and with corners of its own, so that its light is its own. A face of more than
/// kMostTexel texels in a direction repeats its last ones. Nothing of an animated texture but its first frame. Skins
/// take away from `texels_left`; faces for which there are none left are of one colour.
Mesh make_brush_mesh(const Level& level, ModelIndex model, const Vec3<World>& about, std::int64_t& texels_left);

/// The middle of a brush model's box.
Vec3<World> middle_of(const SubModel& model);

}  // namespace oblong
