#pragma once

#include <string>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// A level for timing frames and their stages.
struct BenchLevel {
    std::string name;
    Level level;
    Colormap colormap;
    std::vector<PlacedModel> models;
    std::vector<Camera> cameras;

    Scene scene() const { return {level, colormap, models}; }
};

/// From files.
BenchLevel read_bench_level(const std::string& level, const std::string& cameras, const std::string& palette);
/// A sphere of 288 facets in a room, one of the hard scenes of oblong-accuracy.
BenchLevel make_bench_level(const std::string& palette);

}  // namespace oblong
