#pragma once

#include <string>

namespace oblong::map {

/// entity_classes() as an FGD file for TrenchBroom and Valve's editors. Leaves out families, which editors cannot
/// place, and the keys `classname` and `origin`, which editors define.
std::string fgd_text();

}  // namespace oblong::map
