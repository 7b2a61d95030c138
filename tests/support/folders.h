#pragma once

#include <string>

namespace oblong::test {

/// The project's folder, and the one that it is built in; absolute, without a slash at the end. Functions and not
/// definitions for the compiler: so that a test's object file is the same wherever the project stands, and a compiler
/// cache has it for every checkout.
std::string source_folder();
std::string build_folder();

}  // namespace oblong::test
