#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/files/rendering_times.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/measured_level.h"

namespace oblong {

/// A progress line on standard error; none if `is_shown` is false.
class Progress {
  public:
    explicit Progress(bool is_shown) : is_shown_(is_shown) {}
    ~Progress();
    Progress(const Progress&) = delete;

    /// Begins a part of the work with `steps` steps, from `from` to `to` per cent of the whole.
    void begin(const std::string& what, std::size_t steps, int from, int to);
    void step();

  private:
    void show();

    bool is_shown_;
    std::string what_;
    std::size_t steps_ = 1, done_ = 0;
    int from_ = 0, to_ = 0, shown_ = -1;
};

/// The times of one setting: medians over the rounds of each frame, then the mean over frames.
struct SettingTimes {
    TimeSpread frame;                 ///< with surfaces already lit
    std::optional<TimeSpread> unlit;  ///< with all surfaces rebuilt; for settings with other surfaces, and the default
    std::optional<double> instructions;  ///< a frame
    std::vector<double> by_level;        ///< nanoseconds a frame, medians
};

/// The cost of a frame's sky: the default's time with it and with one colour instead.
struct SkyTimes {
    std::size_t frames = 0;            ///< with sky in view
    double with_sky = 0, without = 0;  ///< nanoseconds, means of these frames' medians
};

struct FrameTimes {
    std::vector<std::optional<SettingTimes>> settings;  ///< by accuracy; none for settings that run the default's code
    SkyTimes sky;
    int rounds = 0, unlit_rounds = 0;
};

/// Times frames of all timed settings in turn: in every round each frame is drawn once by each setting, after an
/// untimed drawing that warms the caches. Nothing is counted or recorded.
FrameTimes time_frames(const Configurations& configurations, std::span<LevelFrames> levels, int rounds,
                       Progress& progress);

}  // namespace oblong
