#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace oblong {

/// Times measured in the last two seconds, and their median.
class RecentTimes {
  public:
    static constexpr std::uint64_t kWindow_us = 2'000'000;

    /// Forgets what is older than the window before `now_us`, which never runs backwards.
    void add(std::uint64_t time_us, std::uint64_t now_us);
    /// The middle one (of an even number: the smaller of the two there; noise only adds); none before the first.
    std::optional<std::uint64_t> median_us() const;
    std::size_t count() const { return samples_.size(); }

  private:
    struct Sample {
        std::uint64_t time_us, at_us;
    };
    std::deque<Sample> samples_;  // oldest first
};

}  // namespace oblong
