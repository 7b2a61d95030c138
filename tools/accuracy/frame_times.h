#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/programs/rendering_times.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/measured_level.h"
#include "tools/map/work_sharing.h"

namespace oblong {

/// The processor's name as the system gives it, or "unknown".
std::string machine_name();
/// The compiler that built this program.
std::string compiler_name();

/// The times of one setting: medians over the rounds of each frame, then the mean over frames.
struct SettingTimes {
    TimeSpread frame;                 ///< with surfaces already lit
    std::optional<TimeSpread> unlit;  ///< with all surfaces rebuilt; for settings with other surfaces, and the default
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
    double share_of_processor = 1;  ///< that this program had while it took times; the rest went to others
};

/// Times frames of all timed settings in turn: in every round each frame is drawn once by each setting, after an
/// untimed drawing that warms the caches. Nothing is counted or recorded. `work` has no workers, and tells the rounds.
FrameTimes time_frames(const Configurations& configurations, std::span<LevelFrames> levels, int rounds,
                       const map::WorkSharing& work);

}  // namespace oblong
