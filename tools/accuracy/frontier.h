#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"

namespace oblong {

/// The error of a combination of settings, and what it costs here and on a 486, in any units.
struct Trial {
    Accuracy accuracy;
    double error = 0;
    std::array<double, 2> costs{};
};

/// Searches the combinations of settings of the dials of texturing spans for those that no other beats: by either cost,
/// each has at most 1 / `step` of the error of all cheaper ones that differ by those dials alone. Starts from the
/// presets and turns, of each of the best found so far, every dial to every setting, until that finds nothing better or
/// `most_trials` have been measured.
std::vector<Accuracy> search_frontier(const std::function<Trial(const Accuracy&)>& measure, std::size_t most_trials,
                                      double step);

/// The dials that differ from the preset that most dials agree with: "1996 perspective=every8".
std::string name_of_combination(const Accuracy& accuracy);

}  // namespace oblong
