#pragma once

#include <string>

#include "tools/accuracy/report.h"

namespace oblong {

/// accuracy.html: a page that needs no other file, for screens of any width, light or dark as the reader's system is.
std::string report_html(const Report& report);

}  // namespace oblong
