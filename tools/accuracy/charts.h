#pragma once

#include <string>

#include "tools/accuracy/report.h"

namespace oblong {

/// What the chart of all settings has across: time on this machine, or on a processor of the time.
enum class CostAxis { Here, I486 };

/// Error against cost of every timed setting whose error is a displacement, with the front of those that no other beats
/// in both, and the presets' names. `width`: units of the drawing, about a pixel each.
std::string tradeoff_chart(const Report& report, CostAxis across, double width, const std::string& css_class);

/// A dial's settings: bars of error and cost.
std::string dial_chart(const Report& report, const Configurations::DialRows& dial);

}  // namespace oblong
