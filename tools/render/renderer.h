#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/methods/hidden_surfaces.h"
#include "engine/models/level_models.h"
#include "engine/programs/rendering_times.h"

namespace oblong {

struct FrameReport {
    std::uint32_t crc32 = 0;
    TimeSpread frame_ns;  ///< of the timed renderings, drawing only
    double first_ns = 0;  ///< of the first rendering, which lights surfaces that no earlier frame showed
    std::int64_t pixels_once = 0, pixels_twice = 0, pixels_never = 0;
    std::vector<NamedCount> counts;
    std::vector<PlanLine> passes, effects;  ///< the parts of the frame, in the same renderings; the plan's effects
};

/// The median and the 99th percentile of some times (at least one).
struct TimeSummary {
    double median = 0, p99 = 0;
};
TimeSummary summarize_times(std::vector<double> times);

/// A rendering job.
struct RenderJob {
    Scene scene;
    ScreenMode mode;
    Settings settings;
    std::span<const ViewSpec> views;
    int repeat = 1;                                        ///< timed renderings of each frame
    bool times_passes = true;                              ///< false: only whole frames
    std::int64_t time_step_ms = 0;                         ///< between these: moving parts are lit and drawn anew
    const LevelModels* level_models = nullptr;             ///< drawn instead of the scene's; outlive the job
    const HiddenSurfaceMethod* hidden_surfaces = nullptr;  ///< the workspace's claimer
};

/// Renders every view and calls on_picture(index, pixels) with each picture. Counts are taken in a separate rendering,
/// never in a timed one.
std::vector<FrameReport> render_views(
    const RenderJob& job, FrameWorkspace& work,
    const std::function<void(std::size_t, std::span<const std::uint8_t>)>& on_picture);

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

/// The plan of each frame as text: what `oblong-render --plan` prints.
std::string plan_text(const std::vector<FrameReport>& frames);

/// The JSON that `oblong-render --json` writes.
std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames);

}  // namespace oblong
