#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "tools/map/work_sharing.h"

namespace oblong::map {

/// Shows a compilation's progress and its stage's remaining seconds on standard error: from its second second on, on a
/// terminal as one line that is overwritten, else as a line every five seconds.
class ProgressLine final : public CompileProgress {
  public:
    ProgressLine();
    ~ProgressLine() override { clear(); }

    void begin(const char* stage, std::size_t steps) override;
    void step(std::size_t steps) override;
    void clear();  ///< removes the line before other output

    /// "tree 0.3 s, visibility 2.1 s, light 4.0 s": the times of the stages; ends the last one.
    std::string times();

  private:
    using Clock = std::chrono::steady_clock;

    static double seconds_since(Clock::time_point time);

    Clock::time_point start_, stage_start_, last_shown_;
    struct StageTime {
        std::string stage;
        double seconds = 0;
    };

    void end_stage();

    std::vector<StageTime> times_;
    std::string stage_;
    std::size_t steps_ = 1, done_ = 0;
    bool is_terminal_, is_shown_ = false;
};

}  // namespace oblong::map
