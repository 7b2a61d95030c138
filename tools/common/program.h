#pragma once

#include <functional>
#include <string>

namespace oblong {

/// Runs a program's body, checks that its standard output was written, and turns exceptions into messages and exit
/// codes: 0 success; 1 a failure, `PROGRAM: FILE: WHERE: what is wrong` on standard error; 2 wrong usage.
int run_program(const std::string& name, const std::function<void()>& body);

}  // namespace oblong
