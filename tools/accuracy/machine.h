#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace oblong {

/// The processor's name as the system gives it, or "unknown".
std::string machine_name();
/// The compiler that built this program.
std::string compiler_name();

/// Counts the instructions that this thread executes, if the machine has a counter that programs may read (Linux:
/// perf_event_open). Many virtual machines have none.
class InstructionCounter {
  public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;

    bool is_available() const { return file_ >= 0; }
    void start();
    /// The instructions since start(); none if they cannot be counted.
    std::optional<std::int64_t> stop();

  private:
    int file_ = -1;
};

}  // namespace oblong
