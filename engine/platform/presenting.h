#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// The mask of the CRT look: factors for the colours of a picture of `rows` rows, shown in width x height pixels. Each
/// row is dark at its edges (but not if rows are below two pixels high); columns let red, green and blue through in
/// turn. Pixels are ARGB, 255 in a channel is factor 1; rows from top to bottom. Sizes above 0.
std::vector<std::uint32_t> make_crt_mask(std::int32_t width_px, std::int32_t height_px, std::int32_t rows);

/// When pictures are due at a frame rate. Intervals add up exactly: a picture that is a little late does not delay the
/// next ones.
class FramePacing {
  public:
    /// The microseconds that a picture ready at `now_us` has to wait, at `frames_per_second` at most (0: no limit).
    /// Called once for each picture, with a monotonic clock.
    std::uint64_t next_wait_us(std::uint64_t now_us, std::int32_t frames_per_second);

  private:
    std::int32_t frames_per_second_ = 0;
    std::uint64_t start_us_ = 0, frames_ = 0;  // the start of counting, and the number of frames since
};

}  // namespace oblong
