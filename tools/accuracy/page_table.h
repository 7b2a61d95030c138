#pragma once

#include <string>

#include "tools/accuracy/report.h"

namespace oblong {

/// A table of the presets in Markdown: errors and modelled frame rates, which are the same on every machine.
std::string preset_table(const Report& report);

/// A page with what stands between its lines `<!-- oblong-accuracy -->` and `<!-- end -->` replaced. Throws InputError
/// that names the file if it has no such lines.
std::string with_table(const std::string& page, const std::string& file, const std::string& table);

}  // namespace oblong
