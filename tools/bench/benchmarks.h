#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/view/screen.h"

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

// Each registers its benchmarks with Google Benchmark. Its arguments must live until these have run.

/// Block kernels, plain and with effects, on blocks of 8 to 64 pixels; the sky, and the building of lit surfaces.
void register_kernel_benchmarks();
/// Each stage of a level's frames separately, on the previous stage's results: walk, polygons, scan, coverage, spans.
void register_stage_benchmarks(const BenchLevel& level, const ScreenMode& mode);

/// Shows the time for each of `count` things (pixels, faces), besides that of the whole iteration.
inline void show_time_per(const char* thing, std::int64_t count, benchmark::State& state) {
    using benchmark::Counter;
    state.counters[thing] = Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

}  // namespace oblong
