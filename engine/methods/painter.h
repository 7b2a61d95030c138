#pragma once

#include "engine/methods/pixel_owners.h"

namespace oblong {

/// The depth by which the painter sorts faces.
enum class SortDepth {
    Farthest,  ///< of the face's part in view (Newell, Newell and Sancha 1972, before their tests)
    Mean       ///< of its nearest and farthest (course notes: "the average")
};

/// An order of faces, farthest first: the reverse of the BSP tree's, which is right for every scene, since the tree
/// splits faces that are both in front of and behind another.
std::vector<std::int32_t> back_to_front_by_tree(const ScannedFaces& scanned);

/// The same by depth, with ties in the tree's order. Wrong where a large face is behind a small one at its farthest
/// point, but in front of it where they overlap; no order is right for faces that overlap in a cycle. Adds to
/// `comparisons`.
std::vector<std::int32_t> back_to_front_by_depth(const ScannedFaces& scanned, SortDepth depth,
                                                 std::int64_t& comparisons);

/// The painter's algorithm: faces back to front, each over the ones before. No depth is stored or compared for pixels,
/// but all pixels of all faces are written. Transparent faces get the pixels that no later face paints over.
void find_owners_by_painting(const ScannedFaces& scanned, std::span<const std::int32_t> back_to_front,
                             PixelOwners& owners);

}  // namespace oblong
