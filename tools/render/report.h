#pragma once

#include <string>
#include <vector>

#include "engine/accuracy/presets.h"
#include "tools/render/renderer.h"

namespace oblong {

/// The contents of a report besides its frames.
struct ReportHead {
    std::string level;
    Preset preset = Preset::Bounded;
    ScreenMode mode;
    Degrees field_of_view;
    Settings settings;
    HiddenSurfaces hidden_surfaces = HiddenSurfaces::SpanBuffer;
    int threads = 1;               ///< that drew
    double load_milliseconds = 0;  ///< of the level, up to its first frame
};

TimeSummary summarize_times(const std::vector<FrameReport>& frames);

/// The plan of each frame for reading: what `oblong-render --plan` prints.
std::string plan_text(const std::vector<FrameReport>& frames);

/// The JSON that `oblong-render --json` writes.
std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames);

}  // namespace oblong
