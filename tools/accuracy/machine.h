#pragma once

#include <string>

namespace oblong {

/// The processor's name as the system gives it, or "unknown".
std::string machine_name();
/// The compiler that built this program.
std::string compiler_name();

}  // namespace oblong
