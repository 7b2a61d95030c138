#include "tools/accuracy/machine.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace oblong {

std::string machine_name() {
    std::ifstream cpus("/proc/cpuinfo");
    for (std::string line; std::getline(cpus, line);) {
        const std::size_t colon = line.find(':');
        if (!line.starts_with("model name") || colon == std::string::npos) continue;
        return line.substr(std::min(colon + 2, line.size())) + ", " +
               std::to_string(std::thread::hardware_concurrency()) + " threads";
    }
    return "unknown";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "gcc " __VERSION__;
#else
    return "unknown";
#endif
}

}  // namespace oblong
