#pragma once

#include <string>

#include "tools/accuracy/report.h"

namespace oblong {

/// accuracy.json: `dials` and `tiers` (the presets), each with settings by name, their errors and costs; then the
/// levels, and how they were measured. Costs are of a mean frame. Pictures of errors are PNG files in hexadecimal
/// digits.
std::string report_json(const Report& report);

/// accuracy.html: page.html with accuracy.json in it, which its script draws; a single file.
std::string report_page(std::string json);

/// A table of the presets in Markdown: errors and modelled frame rates, which are the same on every machine.
std::string preset_table(const Report& report);

/// A page with the text between its lines `<!-- oblong-accuracy -->` and `<!-- end -->` replaced. Throws InputError
/// that names the file if it lacks these lines.
std::string with_table(const std::string& page, const std::string& file, const std::string& table);

}  // namespace oblong
