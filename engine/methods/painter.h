#pragma once

#include "engine/methods/pixel_owners.h"

namespace oblong {

/// The depth by which the painter sorts faces.
enum class SortDepth {
    Farthest,  ///< of the face's part in view (Newell, Newell and Sancha 1972, before their tests)
    Mean       ///< of its nearest and farthest (course notes: "the average")
};

/// An order of faces, farthest first: the reverse of the tree's, which is right for every scene, since the tree splits
/// faces until none can be both in front of and behind another.
std::vector<std::int32_t> back_to_front_by_tree(const ScannedFaces& scanned);

/// The same by depth, equal ones as the tree has them. Wrong where a large face is behind a small one by its farthest
/// point, but not where they overlap; no order is right where faces overlap in a cycle. `comparisons` are counted.
std::vector<std::int32_t> back_to_front_by_depth(const ScannedFaces& scanned, SortDepth depth,
                                                 std::int64_t& comparisons);

/// The painter's algorithm: faces back to front, each over those before it. No depth is kept and nothing compared at a
/// pixel, but all pixels of all faces are written. Faces that are seen through get those that no later face paints
/// over.
void find_owners_by_painting(const ScannedFaces& scanned, std::span<const std::int32_t> back_to_front,
                             PixelOwners& owners);

}  // namespace oblong
