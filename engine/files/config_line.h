#pragma once

#include <optional>
#include <string>

namespace oblong {

/// NAME = VALUE of an options file. A NAME alone has the value "true", as a flag on a command line.
struct ConfigLine {
    std::string name, value;
};

/// Reads one line of an options file, as CLI11 does: a comment begins with # or, at the beginning of a line, with ;
/// quotes around name and value fall away. Nothing for an empty line or a comment. Throws InputError without a place
/// for what is neither.
std::optional<ConfigLine> parse_config_line(const std::string& line);

}  // namespace oblong
