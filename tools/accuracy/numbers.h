#pragma once

#include <string>

namespace oblong {

/// For people: three significant digits without exponent, "0.0213", "375", "12,400"; "0" for 0.
std::string number_text(double value);
/// The same without zeros behind the last other digit: "0.1", "10".
std::string short_number_text(double value);
/// Of a time in nanoseconds, with its unit.
std::string microseconds_text(double nanoseconds);

}  // namespace oblong
