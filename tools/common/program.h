#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace oblong {

/// Runs a program's body, checks that its standard output was written, and turns exceptions into messages and exit
/// codes: 0 success; 1 a failure, `PROGRAM: FILE: WHERE: what is wrong` on standard error; 2 wrong usage.
int run_program(const std::string& name, const std::function<void()>& body);

/// Warns on standard error that faces of a level do not meet at so many edges; prints nothing if there are none.
void warn_of_torn_edges(const std::string& program, const std::string& level_file, std::size_t edges);

}  // namespace oblong
