#pragma once

#include <string>
#include <vector>

#include "tools/render/renderer.h"

namespace oblong {

/// What a report says beside its frames.
struct ReportHead {
    std::string level, accuracy;
    ScreenMode mode;
    int threads = 1;
    double load_milliseconds = 0;
};

/// The middle and the 99th of 100 frames' times, microseconds.
struct TimeSummary {
    double median = 0, p99 = 0;
};
TimeSummary summarize_times(const std::vector<FrameReport>& frames);

/// The JSON that `oblong-render --json` writes.
std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames);

}  // namespace oblong
