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

/// A frame that was just drawn, and what it left in its workspace. The engine knows nothing of logs: lines are worked
/// out afterwards, from what the frame was drawn with and from what it left.
struct LoggedFrame {
    const Scene& scene;
    const ViewSpec& view;
    const ScreenMode& mode;
    const Settings& settings;
    const FrameWorkspace& work;
};

using LogLines = std::vector<std::string>;

/// What the level holds, and what its reader and its effects warn of.
LogLines level_lines(const LoggedFrame& frame);
/// Bytes by room of the engine, and of all: what a frame has touched, not the rest of the arena of lit surfaces.
LogLines memory_lines(const LoggedFrame& frame);
/// Where the eye was placed, the view matrix row by row, the multipliers of the projection, the planes of the frustum.
LogLines matrix_lines(const LoggedFrame& frame);
/// How many of the faces that own pixels cross which side of the view; for the face in the middle of the picture its
/// corners with their outcodes, and what clipping made of them.
LogLines clip_lines(const LoggedFrame& frame);
/// Spans and pixels of each list of faces, and the spans of the middle row with their faces.
LogLines span_lines(const LoggedFrame& frame);

/// The totals of a surface cache at some frame.
struct CacheTotals {
    std::int64_t surfaces = 0, texels = 0, evicted = 0;
};
/// How many lit surfaces were built and how many made room for others since `before`, and how full it is.
LogLines cache_lines(const LoggedFrame& frame, CacheTotals& before);

/// The view that a frame is drawn with.
ViewContext view_of(const LoggedFrame& frame);

/// Writes the lines of some channels, each line with its channel's name before it.
class FrameLog {
  public:
    using Write = std::function<void(const std::string& line)>;
    FrameLog(LogChannels channels, Write write) : channels_(channels), write_(std::move(write)) {}

    LogChannels channels() const { return channels_; }
    /// Writes what the channels say of a frame; what they say of the level, at the first frame alone.
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
