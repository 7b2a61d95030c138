#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/files/rendering_times.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/measured_level.h"
#include "tools/map/work_sharing.h"

namespace oblong {

/// The processor's name as the system gives it, or "unknown".
std::string machine_name();
/// The compiler that built this program.
std::string compiler_name();

/// Counts the instructions that this thread executes, if the machine has a counter that programs may read (Linux:
/// perf_event_open). Many virtual machines have none.
class InstructionCounter {
  public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;

    bool is_available() const { return file_ >= 0; }
    void start();
    /// The instructions since start(); none if they cannot be counted.
    std::optional<std::int64_t> stop();

  private:
    int file_ = -1;
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
/// untimed drawing that warms the caches. Nothing is counted or recorded. `work` has no workers, and tells the rounds.
FrameTimes time_frames(const Configurations& configurations, std::span<LevelFrames> levels, int rounds,
                       const map::WorkSharing& work);

}  // namespace oblong
