#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/frame/frame_plan.h"
#include "engine/scene/level_effects.h"

namespace oblong {

struct FrameCounts;  // engine/frame/frame_counts.h
struct FrameRecord;  // engine/frame/frame_record.h

/// A program's clock: nanoseconds since any time.
using FrameClock = std::int64_t (*)();

/// The times of a frame, measured on request.
struct PassTimes {
    FrameClock clock = nullptr;
    std::uint32_t samples_asked = 0;                      ///< in all frames; selects what SampledStopwatch times
    std::int64_t walk_ns = 0;                             ///< estimated from samples; inaccurate for short walks
    std::int64_t claims_ns = 0;                           ///< the walk, polygons, scan, span buffer
    std::array<std::int64_t, kPassCount> passes_ns{};     ///< by index in kPasses
    std::array<std::int64_t, kEffectCount> effects_ns{};  ///< by Effect, outside its own pass
};

/// Adds the time of its scope to one of the times, if they are measured.
class Stopwatch {
  public:
    Stopwatch(PassTimes* times, std::int64_t PassTimes::*sum) : Stopwatch(times, times ? &(times->*sum) : nullptr) {}
    Stopwatch(PassTimes* times, Effect effect) : Stopwatch(times, times ? &item(times->effects_ns, effect) : nullptr) {}
    /// Of a pass, by its index in kPasses.
    Stopwatch(PassTimes* times, std::size_t pass) : Stopwatch(times, times ? &times->passes_ns[pass] : nullptr) {}
    Stopwatch(const Stopwatch&) = delete;
    ~Stopwatch() {
        if (clock_) *sum_ += clock_() - began_ns_;
    }

  private:
    Stopwatch(const PassTimes* times, std::int64_t* sum) : clock_(times ? times->clock : nullptr), sum_(sum) {
        if (clock_) began_ns_ = clock_();
    }

    FrameClock clock_;
    std::int64_t* sum_;
    std::int64_t began_ns_ = 0;
};

/// Estimates the time of scopes that are so short and so many that reading the clock in each would take a good part of
/// the frame: it times one scope in 17, minus the time to read the clock, and counts it 17 times. The number is odd, as
/// two kinds of scopes often alternate. A sum may be slightly below 0.
class SampledStopwatch {
  public:
    SampledStopwatch(PassTimes* times, std::int64_t PassTimes::*sum)
        : SampledStopwatch(times, times ? &(times->*sum) : nullptr) {}
    SampledStopwatch(PassTimes* times, Effect effect)
        : SampledStopwatch(times, times ? &item(times->effects_ns, effect) : nullptr) {}
    SampledStopwatch(const SampledStopwatch&) = delete;
    ~SampledStopwatch() {
        if (clock_) *sum_ += kSample * (clock_() - began_ns_ - reading_ns_);
    }

  private:
    static constexpr std::uint32_t kSample = 17;

    SampledStopwatch(PassTimes* times, std::int64_t* sum) : sum_(sum) {
        if (!times || ++times->samples_asked % kSample != 0) return;
        clock_ = times->clock;
        const std::int64_t before_ns = clock_();
        began_ns_ = clock_();
        reading_ns_ = began_ns_ - before_ns;
    }

    FrameClock clock_ = nullptr;
    std::int64_t* sum_;
    std::int64_t began_ns_, reading_ns_;  ///< set if `clock_` is
};

/// What is measured while a frame is drawn; null: not measured. Observers never change the picture. A counted or
/// recorded frame is drawn by one thread.
struct FrameObservers {
    FrameCounts* counts = nullptr;
    FrameRecord* record = nullptr;
    PassTimes* times = nullptr;
};

}  // namespace oblong
