#include "engine/files/config_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

[[noreturn]] void refuse(const std::string& line) {
    throw InputError("", "'" + line + "', expected NAME = VALUE");
}

bool is_control(char letter) {
    return (static_cast<unsigned char>(letter) < ' ' && letter != '\t') || letter == '\x7f';
}

// Without arrays: a value is all that follows, commas and brackets too.
CLI::ConfigINI line_reader() {
    constexpr char kNever = '\x01';  // no line with control characters comes so far
    CLI::ConfigINI reader;
    reader.comment('#')->arrayBounds(kNever, kNever)->arrayDelimiter(kNever)->parentSeparator(kNever);
    return reader;
}

}  // namespace

std::optional<ConfigLine> parse_config_line(const std::string& line) {
    constexpr std::size_t kShortest = 3;  // shorter lines are skipped by the reader
    const std::string text = CLI::detail::trim_copy(line);
    if (text.empty() || text.front() == '#' || text.front() == ';') return std::nullopt;
    if (text.size() < kShortest || text.front() == '[' || std::any_of(text.begin(), text.end(), is_control))
        refuse(text);
    std::istringstream input(text);
    const std::vector<CLI::ConfigItem> items = line_reader().from_config(input);
    if (items.size() != 1 || items.front().inputs.size() != 1 || items.front().name.empty()) refuse(text);
    return ConfigLine{items.front().name, items.front().inputs.front()};
}

}  // namespace oblong
