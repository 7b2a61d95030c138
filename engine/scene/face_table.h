#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/level_effects.h"

namespace oblong {

/// Texels per world unit: 48.16.
using TexelDensity = Fixed<std::int64_t, 16>;
/// The same of a face: 16.16, as components of texture axes are below 256.
using StoredDensity = Fixed<std::int32_t, 16>;

/// Data of a face, precomputed for all frames.
struct PreparedFace {
    std::uint32_t first_corner = 0;  ///< in FaceTable::corners
    StoredDensity density;           ///< texels of mip level 0 per unit, along the denser axis
    StoredDensity least_density;     ///< a lower bound for all directions on the face
    EffectSet effects;               ///< needed to draw it
    LevelNumber corner_count = 0;
    Material material = Material::Lit;
    bool is_above_fog = false;     ///< certainly, while its model has not moved
    bool is_near_lantern = false;  ///< false: no lantern's light touches it, while its model has not moved
    std::uint8_t blend = 0;        ///< a translucent face's, into LevelCache::blends, from 1
};

/// Data of a level's faces, precomputed for all frames.
struct FaceTable {
    Table<PreparedFace, Face> faces;
    std::vector<VertexIndex> corners;  ///< of all faces, including vertices inserted at T-junctions
    std::size_t most_corners = 0;      ///< of one face
    std::size_t torn_edges = 0;        ///< edges of the world where faces do not meet; pixels may stay free there

    const PreparedFace& operator[](FaceIndex face) const { return faces[face]; }
    PreparedFace& operator[](FaceIndex face) { return faces[face]; }
    std::span<const VertexIndex> corners_of(FaceIndex face) const {
        return std::span(corners).subspan(faces[face].first_corner, as_size(faces[face].corner_count));
    }
};

/// The table of a level; its faces keep their indices.
FaceTable make_face_table(const Level& level);

}  // namespace oblong
