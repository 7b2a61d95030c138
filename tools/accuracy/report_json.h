#pragma once

#include <string>

#include "tools/accuracy/report.h"

namespace oblong {

/// accuracy.json: `dials` and `tiers` (the presets), each with settings by name, their errors and costs; then what was
/// measured, and how. Costs are of a mean frame.
std::string report_json(const Report& report);

}  // namespace oblong
