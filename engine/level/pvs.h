#pragma once

#include <cstdint>
#include <span>

#include "engine/level/level.h"

namespace oblong {

/// Bytes of a set of the world's leaves: one bit each, leaf 0 (the solid outside) left out.
std::size_t visible_set_size(const Level& level);

/// Which leaves may be seen from anywhere in `leaf` (the potentially visible set), into `visible`, which must be of
/// visible_set_size bytes. All leaves from the solid outside and from leaves without a set.
void unpack_visible_set(const Level& level, std::int32_t leaf, std::span<std::uint8_t> visible);

/// Whether a set has a leaf; false for the solid outside and for leaves of other models than the world.
inline bool is_in_set(std::span<const std::uint8_t> visible, std::int32_t leaf) {
    const auto bit = static_cast<std::size_t>(leaf) - 1;
    return leaf > 0 && bit / 8 < visible.size() && (visible[bit / 8] >> bit % 8 & 1) != 0;
}

}  // namespace oblong
