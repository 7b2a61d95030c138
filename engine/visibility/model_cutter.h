#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// A part of a brush model's face that lies in one leaf of the world.
struct Fragment {
    FaceIndex face;
    LeafIndex leaf;
    PlacedIndex placed;
    std::uint32_t first_corner = 0, corner_count = 0;
    Index<struct FragmentTree> tree =
        Index<FragmentTree>::none();  ///< that holds its corners; none: they are in the model's cut
};

/// Which side of a plane a polygon is on; corners within 1/1,024 unit of it are on it, so that no piece is thinner.
enum class PolygonSide : std::uint8_t { On, Front, Back, Both };

/// The side of a polygon to a plane moved by `offset`; `distances` becomes the distance of each corner, 0 for those on
/// it.
PolygonSide polygon_side(const LevelPlane& plane, const Vec3<World>& offset, std::span<const Vec3<World>> polygon,
                         std::vector<PlaneDistance>& distances);

/// Appends to `corners` the part of a polygon on one side of a plane; `distances` are those of its corners. The
/// polygon begins at `first` in `corners` itself. Both parts get the same corners on the plane.
void append_part(std::vector<Vec3<World>>& corners, std::uint32_t first, std::span<const PlaneDistance> distances,
                 bool in_front);

/// All parts of one placed model.
struct ModelCut {
    std::vector<Fragment> fragments;
    std::vector<Vec3<World>> corners;
};

/// Cuts a model's faces by the planes of the world's tree, down to its leaves; parts in solid are left out. `placed` is
/// the index that its fragments get.
ModelCut cut_model(const Level& level, const PlacedModel& model, PlacedIndex placed, const FaceTable& table);

}  // namespace oblong
