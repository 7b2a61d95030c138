#pragma once

#include <stdexcept>
#include <string>

namespace oblong {

/// Bad input: what was read is not what it should be. `where` names the place in it ("lump planes, offset 1234"), the
/// message says what is wrong and what was expected. Who opened the file adds its name: programs print
/// `PROGRAM: FILE: WHERE: what is wrong, what was expected` and exit with 1.
class InputError : public std::runtime_error {
  public:
    InputError(std::string where_in_input, const std::string& what_is_wrong)
        : std::runtime_error(what_is_wrong), where(std::move(where_in_input)) {}

    std::string where;
};

}  // namespace oblong
