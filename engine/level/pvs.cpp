#include <algorithm>

#include "engine/base/table.h"
#include "engine/level/level.h"

namespace oblong {

namespace {

void set_all(std::span<std::uint8_t> visible, std::int32_t leaf_count) {
    std::fill(visible.begin(), visible.end(), std::uint8_t{0xff});
    const int last_bits = leaf_count % 8;
    if (last_bits != 0) visible.back() = static_cast<std::uint8_t>((1 << last_bits) - 1);
}

}  // namespace

std::size_t visible_set_size(const Level& level) {
    return as_size(level.world().visible_leaf_count + 7) / 8;
}

void unpack_visible_set(const Level& level, LeafIndex leaf, std::span<std::uint8_t> visible) {
    const std::int32_t start = level.leaves[leaf].visibility_offset;
    if (leaf == kSolidOutside || start == -1) return set_all(visible, level.world().visible_leaf_count);

    // The reader has checked that the row ends inside the lump; a run of zeros may extend beyond the set's end.
    const std::uint8_t* packed = level.visibility.data() + start;
    for (std::size_t i = 0; i < visible.size();) {
        if (*packed != 0) {
            visible[i++] = *packed++;
            continue;
        }
        const std::size_t end = std::min(visible.size(), i + packed[1]);
        std::fill(visible.begin() + static_cast<std::ptrdiff_t>(i), visible.begin() + static_cast<std::ptrdiff_t>(end),
                  std::uint8_t{0});
        i = end;
        packed += 2;
    }
}

}  // namespace oblong
