#include "engine/measure/error_summary.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oblong {

ErrorSummary summarize_pixels(std::span<const TexelError> errors) {
    std::vector<float> measured;
    measured.reserve(errors.size());
    for (const TexelError& error : errors)
        if (error.is_measured()) measured.push_back(error.pixels);
    return summarize_errors(std::move(measured));
}

ErrorSummary summarize_errors(std::vector<float> errors) {
    if (errors.empty()) return {};
    double squares = 0;
    for (const float error : errors) squares += static_cast<double>(error) * error;
    const auto at_p99 = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() * 99 + 99) / 100 - 1);
    std::nth_element(errors.begin(), at_p99, errors.end());
    return {static_cast<std::int64_t>(errors.size()), std::sqrt(squares / static_cast<double>(errors.size())), *at_p99,
            *std::max_element(at_p99, errors.end())};
}

}  // namespace oblong
