#include "tools/map/source/nearest_name.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace oblong::map {
namespace {

// The number of letters to change, add, remove or swap with the next one (Damerau, Levenshtein).
std::size_t typing_errors(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = std::exchange(last, now);
    }
    return last.back();
}

}  // namespace

void NearestName::add(std::string_view name) {
    constexpr std::size_t kLongest = 64;
    if (name.ends_with('#')) name.remove_suffix(1);
    if (name.ends_with('*') || wanted_.size() > kLongest) return;
    const std::size_t errors = typing_errors(wanted_, name);
    if (errors >= least_) return;
    least_ = errors;
    name_ = name;
}

std::string NearestName::text() const {
    return name_.empty() ? "" : ", perhaps '" + std::string(name_) + "' is meant";
}

}  // namespace oblong::map
