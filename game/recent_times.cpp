#include "game/recent_times.h"

#include <algorithm>
#include <vector>

namespace oblong {

void RecentTimes::add(std::uint64_t time_us, std::uint64_t now_us) {
    samples_.push_back({time_us, now_us});
    while (now_us - samples_.front().at_us > kWindow_us) samples_.pop_front();
}

std::optional<std::uint64_t> RecentTimes::median_us() const {
    if (samples_.empty()) return std::nullopt;
    std::vector<std::uint64_t> times_us;
    for (const Sample& sample : samples_) times_us.push_back(sample.time_us);
    const auto middle = times_us.begin() + static_cast<std::ptrdiff_t>((times_us.size() - 1) / 2);
    std::nth_element(times_us.begin(), middle, times_us.end());
    return *middle;
}

}  // namespace oblong
