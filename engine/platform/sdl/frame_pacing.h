#pragma once

#include <cstdint>

namespace oblong {

/// When pictures are due at a frame rate. Intervals add up exactly: a picture that is a little late does not delay the
/// next ones.
class FramePacing {
  public:
    /// The microseconds that a picture ready at `now_us` has to wait, at `frames_per_second` at most (0: no limit).
    /// Called once for each picture, with a monotonic clock.
    std::uint64_t next_wait_us(std::uint64_t now_us, std::int32_t frames_per_second) {
        if (frames_per_second <= 0) return 0;
        constexpr std::uint64_t kSecond_us = 1'000'000;
        const auto rate = static_cast<std::uint64_t>(frames_per_second);
        const std::uint64_t due_us = start_us_ + frames_ * kSecond_us / rate;
        // More than a frame late: the missed pictures are skipped.
        if (frames_per_second != frames_per_second_ || now_us > due_us + kSecond_us / rate) {
            frames_per_second_ = frames_per_second;
            start_us_ = now_us;
            frames_ = 1;
            return 0;
        }
        ++frames_;
        return due_us > now_us ? due_us - now_us : 0;
    }

  private:
    std::int32_t frames_per_second_ = 0;
    std::uint64_t start_us_ = 0, frames_ = 0;  // the start of counting, and the number of frames since
};

}  // namespace oblong
