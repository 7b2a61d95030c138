#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/frame_counts.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// A clock for frames: nanoseconds of std::chrono::steady_clock.
std::int64_t steady_clock_ns();

/// The median and the quartiles of some times; nanoseconds.
struct TimeSpread {
    double median = 0, low = 0, high = 0;
};
/// Of at least one time.
TimeSpread spread_of(std::vector<double> times_ns);
/// "+-3%": half of the interquartile range, as a percentage of the median, rounded up. " busy" above 99: other programs
/// have the processor, and the times tell nothing.
std::string spread_text(const TimeSpread& times);
/// Whether the quartile ranges do not overlap.
inline bool are_apart(const TimeSpread& a, const TimeSpread& b) {
    return a.high < b.low || b.high < a.low;
}

struct PlanLine {
    std::string_view name;
    std::int64_t pixels = 0;
    double nanoseconds = 0;          ///< the part of the frame's median
    double low_ns = 0, high_ns = 0;  ///< quartiles
};

/// Times of renderings of one view, by pass. All programs time frames with it. A view is drawn once before, so that its
/// surfaces are lit and its caches warm.
class RenderingTimes {
  public:
    /// Keeps the last `most` renderings.
    explicit RenderingTimes(std::size_t most, FrameClock clock = steady_clock_ns) : most_(most), watch_{clock} {}

    /// Times draw(), which draws one frame with this workspace. Reading the clock for the passes takes a few per cent
    /// of the time: without that, all of a frame is "other".
    template <class Draw>
    void time(FrameWorkspace& work, Draw draw, bool of_passes = true) {
        if (!of_passes) watch_ = {watch_.clock};
        work.observers.times = of_passes ? &watch_ : nullptr;
        const std::int64_t began_ns = watch_.clock();
        draw();
        const std::int64_t taken_ns = watch_.clock() - began_ns;
        work.observers.times = nullptr;
        add(taken_ns);
    }
    void clear() { renderings_.clear(); }
    std::size_t count() const { return renderings_.size(); }

    /// Requires at least one rendering, as do the following.
    TimeSpread frame_ns() const;
    /// "walk", "claims", the plan's passes, and "other" for the rest, so that the lines add up to the frame's median:
    /// each has its share of the renderings whose times are the middle half.
    std::vector<PlanLine> pass_lines(const FramePlan& plan, const FrameCounts& counts) const;
    /// The plan's effects: each is a part of passes, or a pass.
    std::vector<PlanLine> effect_lines(const FramePlan& plan, const FrameCounts& counts) const;

  private:
    struct Rendering {
        std::int64_t frame_ns;
        PassTimes times;
    };

    void add(std::int64_t taken_ns);
    std::vector<const Rendering*> middle_half() const;
    template <class TimeOf>
    PlanLine line_of(std::string_view name, std::int64_t pixels, TimeOf time_of) const;
    template <class TimeOf>
    std::vector<double> times_of(TimeOf time_of) const;

    std::size_t most_;
    PassTimes watch_;
    std::vector<Rendering> renderings_;  // oldest first
};

}  // namespace oblong
