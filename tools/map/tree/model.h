#pragma once

#include <optional>

#include "tools/map/tree/mesh.h"
#include "tools/map/tree/portals.h"
#include "tools/map/tree/surfaces.h"

namespace oblong::map {

/// The world, or a brush entity, compiled: before its numbering for the file.
struct CompiledModel {
    Box box;
    Tree tree;
    Portals portals;
    std::vector<Surface> surfaces;  ///< grouped by node
    std::vector<Loop> loops;        ///< of each surface, the corners in `vertices`
    VertexPool vertices;
    std::array<Tree, 2> hulls;  ///< for kPlayerBox and kLargeBox; leaves are solid or empty
};

/// Where a sealed level must not be open to the void, or nothing for a model that needs no seal.
using SealStarts = std::optional<std::vector<Point>>;

struct ModelResult {
    CompiledModel model;
    std::optional<Leak> leak;  ///< then the model is not complete
};

/// Compiles brushes into a model. With `starts`, fills what is outside of the level.
ModelResult compile_model(const std::vector<Brush>& brushes, PlaneList& planes, const std::vector<TexInfo>& texinfos,
                          const SealStarts& starts);

}  // namespace oblong::map
