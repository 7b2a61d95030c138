#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/report.h"

namespace oblong {

/// For people: three significant digits without exponent, "0.0213", "375", "12,400"; "0" for 0.
std::string number_text(double value);

/// Sentences on each setting of a dial whose rms error is larger than that of the coarser one before it by more than 2
/// %: how much, and what of the measurements explains it.
std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial);

/// The error that is left at a division a pixel and the defaults of all other dials: what no setting of a dial of
/// displacement goes below. Of other dials that of their most exact setting.
const ErrorSummary& floor_of(const Report& report, const Configurations::DialRows& dial);

/// Sentences on presets that are further off than another one and slower here, by more than half of their times spread.
std::vector<std::string> notes_on_presets(const Report& report);

}  // namespace oblong
