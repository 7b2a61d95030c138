#pragma once

#include <cstdint>
#include <span>

#include "engine/mesh/mesh.h"

namespace oblong {

/// A Quake model: the bytes of an MDL file ("IDPO", version 6), `scale` times as large (above 0, at most 4,096).
///
/// A vertex of the seam that triangles of the skin's back half use is two vertices of the mesh. Places on the skin are
/// those of texels' middles; the ones outside of it, up to as far as it is large, are put onto its border. Normals
/// are computed (set_normals), the file's, which are numbers of a table of 162 directions, are not read. Throws
/// InputError that names the part of the file and the offset: for numbers that are not finite or too large, indices
/// that lead nowhere, counts that the file is too short for or that exceed kMostMeshTriangles and its like.
Mesh read_mdl(std::span<const std::uint8_t> bytes, World scale = World::from_int(1));

}  // namespace oblong
