#include "tools/accuracy/machine.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

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

#ifdef __linux__

InstructionCounter::InstructionCounter() {
    perf_event_attr wanted{};
    wanted.size = sizeof wanted;
    wanted.type = PERF_TYPE_HARDWARE;
    wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
    wanted.disabled = 1;
    wanted.exclude_kernel = 1;
    wanted.exclude_hv = 1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
}

InstructionCounter::~InstructionCounter() {
    if (is_available()) close(file_);
}

void InstructionCounter::start() {
    if (!is_available()) return;
    ioctl(file_, PERF_EVENT_IOC_RESET, 0);
    ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
}

std::optional<std::int64_t> InstructionCounter::stop() {
    std::int64_t count = 0;
    if (!is_available()) return std::nullopt;
    ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
    if (read(file_, &count, sizeof count) != sizeof count) return std::nullopt;
    return count;
}

#else

InstructionCounter::InstructionCounter() = default;
InstructionCounter::~InstructionCounter() = default;
void InstructionCounter::start() {}
std::optional<std::int64_t> InstructionCounter::stop() {
    return std::nullopt;
}

#endif

}  // namespace oblong
