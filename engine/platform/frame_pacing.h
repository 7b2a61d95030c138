#pragma once

#include <cstdint>

namespace oblong {

/// When pictures are due at so many frames a second. Times between pictures add up exactly: a picture that is shown a
/// little late does not delay those after it.
class FramePacing {
  public:
    /// How many microseconds a picture that is ready at `now_us` has to wait until it is due, at
    /// `frames_per_second` at most (0: no limit). Called once for each picture, with a clock that never runs backwards.
    std::uint64_t next_wait_us(std::uint64_t now_us, std::int32_t frames_per_second);

  private:
    std::int32_t frames_per_second_ = 0;
    std::uint64_t start_us_ = 0, frames_ = 0;  // since when frames are counted, and how many there were
};

}  // namespace oblong
