#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/frame/passes.h"
#include "engine/scene/effects.h"

namespace oblong {

struct FrameCounts;  // engine/frame/frame_counts.h
struct FrameRecord;  // engine/frame/frame_record.h

/// A program's clock: nanoseconds since any time.
using FrameClock = std::int64_t (*)();

/// The times of a frame, measured on request.
struct PassTimes {
    FrameClock clock = nullptr;
    std::uint32_t faces_walked = 0;                       ///< in all frames; selects the faces to time
    std::int64_t walk_ns = 0;                             ///< estimated from one face in 16; inaccurate for short walks
    std::int64_t claims_ns = 0;                           ///< the walk, polygons, scan, span buffer
    std::array<std::int64_t, kPassCount> passes_ns{};     ///< by index in kPasses
    std::array<std::int64_t, kEffectCount> effects_ns{};  ///< by Effect, for those without a pass
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

/// What is measured while a frame is drawn; null: not measured. Observers never change the picture. A counted or
/// recorded frame is drawn by one thread.
struct FrameObservers {
    FrameCounts* counts = nullptr;
    FrameRecord* record = nullptr;
    PassTimes* times = nullptr;
};

}  // namespace oblong
