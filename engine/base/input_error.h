#pragma once

#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/base/text.h"

namespace oblong {

/// Text from a damaged file, safe to print: control characters become question marks, long text is truncated.
inline std::string printable(std::string text) {
    text = shortened(std::move(text), 400);
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
    return text;
}

/// "line 12": the place of an error in a text.
inline std::string at_line(std::integral auto line) {
    return "line " + std::to_string(line);
}

/// Invalid input. `where` names the place in the input ("lump planes, offset 1234"), the message says what is wrong and
/// what was expected. The caller that opened the file adds its name: programs print `PROGRAM: FILE: WHERE: what is
/// wrong, what was expected` and exit with 1.
class InputError : public std::runtime_error {
  public:
    InputError(std::string where_in_input, std::string what_is_wrong)
        : std::runtime_error(printable(std::move(what_is_wrong))), where(printable(std::move(where_in_input))) {}

    std::string where;
};

}  // namespace oblong
