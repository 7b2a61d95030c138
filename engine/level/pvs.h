#pragma once

#include <cstdint>
#include <span>

#include "engine/level/level.h"

namespace oblong {

/// Bytes of a set of the world's leaves: one bit each, leaf 0 (the solid outside) left out.
std::size_t visible_set_size(const Level& level);

/// Which leaves may be seen from anywhere in `leaf` (the potentially visible set), into `visible`, which must be of
/// visible_set_size bytes. All leaves from the solid outside and from leaves without a set.
void unpack_visible_set(const Level& level, LeafIndex leaf, std::span<std::uint8_t> visible);

/// Whether a set has a leaf; false for the solid outside and for leaves of other models than the world.
inline bool is_in_set(std::span<const std::uint8_t> visible, LeafIndex leaf) {
    const std::size_t bit = leaf.position() - 1;
    return leaf > kSolidOutside && bit / 8 < visible.size() && (visible[bit / 8] >> bit % 8 & 1) != 0;
}

}  // namespace oblong
