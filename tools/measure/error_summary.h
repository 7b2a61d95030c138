#pragma once

#include <cstdint>
#include <vector>

namespace oblong {

/// Of errors, none negative: the root of the mean square, the 99th percentile (the least error that 99 % of them do not
/// exceed) and the largest. All 0 if there are none.
struct ErrorSummary {
    std::int64_t count = 0;
    double rms = 0, p99 = 0, max = 0;
};

ErrorSummary summarize_errors(std::vector<float> errors);

}  // namespace oblong
