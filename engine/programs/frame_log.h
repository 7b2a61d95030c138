#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/view/views.h"

namespace oblong {

/// The subjects of log lines. A channel is chosen by subject, not by importance, and is off by default.
enum class LogChannel : std::uint8_t { Level, Memory, Matrices, Clip, Spans, Cache };
inline constexpr std::size_t kLogChannelCount = 6;
inline constexpr std::array<std::string_view, kLogChannelCount> kLogChannelNames{"level", "memory", "matrices",
                                                                                 "clip",  "spans",  "cache"};

/// A set of channels.
class LogChannels {
  public:
    static constexpr LogChannels all() { return LogChannels((1u << kLogChannelCount) - 1); }
    static constexpr LogChannels only(LogChannel channel) { return LogChannels(1u << static_cast<unsigned>(channel)); }
    constexpr LogChannels() = default;

    constexpr bool has(LogChannel channel) const { return (bits_ >> static_cast<unsigned>(channel) & 1) != 0; }
    constexpr bool is_empty() const { return bits_ == 0; }
    constexpr LogChannels operator|(LogChannels other) const { return LogChannels(bits_ | other.bits_); }
    constexpr bool operator==(const LogChannels&) const = default;

  private:
    constexpr explicit LogChannels(unsigned bits) : bits_(bits) {}
    unsigned bits_ = 0;
};

/// "matrices,clip": names with commas between them. Throws UsageError that names the known ones.
LogChannels parse_log_channels(const std::string& text);
/// The names of a set, with commas between them; "off" for none.
std::string names_of(LogChannels channels);
/// The next set for the log key: off, each channel alone, all of them.
LogChannels next_channels(LogChannels channels);

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
