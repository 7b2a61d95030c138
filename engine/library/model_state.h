#pragma once

#include <memory>

#include "engine/library/oblong.h"
#include "engine/mesh/placed_mesh.h"

namespace oblong {

struct Model::State {
    std::shared_ptr<Mesh> mesh;  ///< never null; shared with level scenes that will show it
};

/// Places a mesh by a pose and a frame of its motion.
PlacedMesh placed_at(const Mesh& mesh, const Pose& pose, std::int32_t frame);

}  // namespace oblong
