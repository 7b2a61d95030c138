#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tools/accuracy/configurations.h"
#include "tools/accuracy/errors.h"
#include "tools/accuracy/frame_times.h"
#include "tools/accuracy/measured_level.h"
#include "tools/measure/operations.h"
#include "tools/measure/processors.h"

namespace oblong {

/// The number of a stage's events in a mean frame.
struct StageEvents {
    std::string_view stage;
    std::int64_t events = 0;
};

/// The counted cost of one setting's frames, means over the frames.
struct CountedCost {
    std::array<StageEvents, kStageCount> stages{};  ///< of a frame whose surfaces are lit already
    Operations operations;                          ///< of a frame whose surfaces are lit already
    Operations lighting;                            ///< of building all surfaces of a frame
    std::array<double, kProcessors.size()> cycles{}, lighting_cycles{};
};

struct SettingResult {
    ErrorSummaries errors;
    std::vector<ErrorSummaries> by_level;
    CountedCost cost;
};

/// The errors of a frame as a picture: an indexed PNG.
struct HeatMap {
    std::string setting, level;
    std::size_t camera = 0;
    double rms = 0;
    std::vector<std::uint8_t> png;
};

/// A level that was measured.
struct LevelSummary {
    std::string name, about;
    std::size_t cameras = 0, faces = 0;
    double close_calls_per_mille = 0;
};

/// All measurements, and how they were made.
struct Report {
    Configurations configurations;
    std::vector<SettingResult> results;  ///< by accuracy
    FrameTimes times;
    std::vector<std::vector<HeatMap>> heat_maps;  ///< of each dial
    std::vector<LevelSummary> levels;
    std::size_t frames = 0;
    int samples_per_axis = 0;
    bool is_quick = false;
    std::string machine, compiler;
    double seconds = 0;
};

/// The extent of the measurements.
struct Effort {
    int rounds = 31;
    int samples_per_axis = 4;
    bool is_quick = false;
};

/// A level to measure, with the palette and colormap that it is drawn with.
struct MeasuredPlace {
    const MeasuredLevel& level;
    const Palette& palette;
    const Colormap& colormap;
};
Report measure_all(const Configurations& configurations, std::span<const MeasuredPlace> places, const Effort& effort,
                   Progress& progress);

}  // namespace oblong
