#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/files/log_channels.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/view/view_spec.h"

namespace oblong {

/// A frame that was just drawn, and its workspace. The engine does not log: lines are made afterwards from these.
struct LoggedFrame {
    const Scene& scene;
    const ViewSpec& view;
    const ScreenMode& mode;
    const Settings& settings;
    const FrameWorkspace& work;
};

using LogLines = std::vector<std::string>;

/// The contents of the level, and warnings of its reader and its effects.
LogLines level_lines(const LoggedFrame& frame);
/// Bytes by room of the engine, and in total; of the arena of lit surfaces, only the used part.
LogLines memory_lines(const LoggedFrame& frame);
/// The place of the eye, the view matrix row by row, the multipliers of the projection, the planes of the frustum.
LogLines matrix_lines(const LoggedFrame& frame);
/// How many of the faces that own pixels cross each side of the view; for the face in the middle of the picture, its
/// corners with their outcodes, and the corners after clipping.
LogLines clip_lines(const LoggedFrame& frame);
/// Spans and pixels of each list of faces, and the spans of the middle row with their faces.
LogLines span_lines(const LoggedFrame& frame);

/// The totals of a surface cache at some frame.
struct CacheTotals {
    std::int64_t surfaces = 0, texels = 0, evicted = 0;
};
/// How many lit surfaces were built and evicted since `before`, and how full the cache is.
LogLines cache_lines(const LoggedFrame& frame, CacheTotals& before);

/// The view that a frame is drawn with.
ViewContext view_of(const LoggedFrame& frame);

/// Writes the lines of some channels, each line after its channel's name.
class FrameLog {
  public:
    using Write = std::function<void(const std::string& line)>;
    FrameLog(LogChannels channels, Write write) : channels_(channels), write_(std::move(write)) {}

    LogChannels channels() const { return channels_; }
    /// Writes the channels' lines of a frame; those of the level only at the first frame.
    void note(const LoggedFrame& frame);
    /// The same at most once a second.
    void note_each_second(const LoggedFrame& frame, std::uint64_t now_us);

  private:
    LogChannels channels_;
    Write write_;
    CacheTotals cache_;
    bool has_begun_ = false;
    std::uint64_t next_us_ = 0;
};

/// Writes lines to standard error.
FrameLog::Write standard_error_lines();

}  // namespace oblong
