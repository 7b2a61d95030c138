#pragma once

#include <cstdint>
#include <span>

#include "engine/level/level.h"

namespace oblong {

/// Bytes of a set of the world's leaves: one bit each, without leaf 0 (the solid outside).
std::size_t visible_set_size(const Level& level);

/// Writes the potentially visible set of `leaf` to `visible`, which must have visible_set_size() bytes. All leaves for
/// the solid outside and for leaves without a set.
void unpack_visible_set(const Level& level, LeafIndex leaf, std::span<std::uint8_t> visible);

/// False for the solid outside and for leaves of brush models.
inline bool is_in_set(std::span<const std::uint8_t> visible, LeafIndex leaf) {
    const std::size_t bit = leaf.position() - 1;
    return leaf > kSolidOutside && bit / 8 < visible.size() && (visible[bit / 8] >> bit % 8 & 1) != 0;
}

}  // namespace oblong
