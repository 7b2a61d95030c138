#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/report.h"

namespace oblong {

/// A number for readers: three significant digits without exponent, "0.0213", "375", "12,400"; "0" for 0.
std::string number_text(double value);

/// Sentences on each setting of a dial whose rms error is larger than that of the coarser setting before it by more
/// than 2 %: by how much, and why, from the measurements.
std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial);

/// The error with a division for each pixel and all other dials at their defaults: no setting of a dial of displacement
/// has less. For other dials, the error of the most exact setting.
const ErrorSummary& floor_of(const Report& report, const Configurations::DialRows& dial);

/// Sentences on presets that are less exact than another one and slower here, by more than half of the spread of their
/// times.
std::vector<std::string> notes_on_presets(const Report& report);

}  // namespace oblong
