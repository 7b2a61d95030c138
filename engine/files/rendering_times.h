#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/frame/frame_counts.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// A clock for frames: nanoseconds of std::chrono::steady_clock.
std::int64_t steady_clock_ns();

/// The median of some times with the quartiles below and above it; nanoseconds.
struct TimeSpread {
    double median = 0, low = 0, high = 0;
};
/// Of at least one time.
TimeSpread spread_of(std::vector<double> times_ns);
/// "+-3%": half of what lies between the quartiles, of the median, rounded up.
std::string spread_text(const TimeSpread& times);
/// Whether the spread leaves no doubt which of two is less.
inline bool are_apart(const TimeSpread& a, const TimeSpread& b) {
    return a.high < b.low || b.high < a.low;
}

/// A line of a plan as it is shown.
struct PlanLine {
    std::string_view name;
    std::int64_t pixels = 0;
    double nanoseconds = 0;          ///< the median
    double low_ns = 0, high_ns = 0;  ///< quartiles
};

/// What renderings of one view took, and where it went: the one way in which programs time frames. A view is drawn once
/// untimed before, so that its surfaces are lit and its caches warm.
class RenderingTimes {
  public:
    /// Keeps the last `most` renderings.
    explicit RenderingTimes(std::size_t most, FrameClock clock = steady_clock_ns) : most_(most), watch_{clock} {}

    /// Times draw(), which draws one frame with this workspace.
    template <class Draw>
    void time(FrameWorkspace& work, Draw draw) {
        work.observers.times = &watch_;
        const std::int64_t began_ns = watch_.clock();
        draw();
        const std::int64_t taken_ns = watch_.clock() - began_ns;
        work.observers.times = nullptr;
        add(taken_ns);
    }
    void clear() { renderings_.clear(); }
    std::size_t count() const { return renderings_.size(); }

    /// Of at least one rendering, like what follows.
    TimeSpread frame_ns() const;
    /// "walk", "claims", the plan's passes and "other": what belongs to none of those, so that the lines add up to the
    /// frame's median.
    std::vector<PlanLine> pass_lines(const FramePlan& plan, const FrameCounts& counts) const;
    /// The effects on the plan: each a part of passes, or one of them.
    std::vector<PlanLine> effect_lines(const FramePlan& plan, const FrameCounts& counts) const;

  private:
    struct Rendering {
        std::int64_t frame_ns;
        PassTimes times;
    };

    void add(std::int64_t taken_ns);
    template <class TimeOf>
    std::vector<double> times_of(TimeOf time_of) const;

    std::size_t most_;
    PassTimes watch_;
    std::vector<Rendering> renderings_;  // oldest first
};

}  // namespace oblong
