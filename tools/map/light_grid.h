#pragma once

#include "tools/map/bsp_file.h"

namespace oblong::map {

/// The samples of a face's lightmap: at every 16th texel, from the multiple of 16 at or below the least texel of its
/// corners to the one at or above the greatest.
struct LightGrid {
    static constexpr int kStep = 16;
    std::array<int, 2> first{};  ///< in steps: texel / kStep
    std::array<int, 2> count{};

    int size() const { return count[0] * count[1]; }
};

/// Worked out from the numbers in the file, as a reader does.
LightGrid light_grid(const BspFile& bsp, const FileFace& face);

/// The vertices of a face, in order.
std::vector<std::array<float, 3>> face_corners(const BspFile& bsp, const FileFace& face);

}  // namespace oblong::map
