#pragma once

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/reference_polygons.h"
#include "tools/measure/texel_error.h"
#include "tools/probe/probe.h"

namespace oblong::test {

/// In viewspace.
using Triangle = std::array<reference::TexturedCorner, 3>;

inline double snapped(double value) {
    return std::nearbyint(value * 256) / 256;
}

/// The texels that the probe answers for columns `first` to `end` - 1 of a row of a triangle's plane.
inline std::vector<reference::ScreenPoint> ask_for_texels(const std::string& mode, const Accuracy& accuracy,
                                                          const Triangle& triangle, int row, int first, int end) {
    std::ostringstream query;
    query.precision(15);
    query << "texspanq " << mode << " 320 200 4 3 90";
    for (const reference::TexturedCorner& corner : triangle)
        query << ' ' << corner.position.x << ' ' << corner.position.y << ' ' << corner.position.z << ' ' << corner.u
              << ' ' << corner.v;
    query << ' ' << row << ' ' << first << ' ' << end;
    std::istringstream answer(Probe(accuracy).answer(query.str()));
    std::vector<reference::ScreenPoint> texels;
    for (double u, v; answer >> u >> v;) texels.push_back({u, v});
    EXPECT_EQ(texels.size(), static_cast<std::size_t>(end - first)) << query.str();
    return texels;
}

}  // namespace oblong::test
