#pragma once

#include <cstdint>

// Processor instructions that C++ lacks.

namespace oblong::dos {

inline void write_port(std::uint16_t port, std::uint8_t value) {
    asm volatile("outb %0, %1" ::"a"(value), "Nd"(port));
}
inline std::uint8_t read_port(std::uint16_t port) {
    std::uint8_t value;
    asm volatile("inb %1, %0" : "=a"(value) : "Nd"(port));
    return value;
}

/// Disables interrupts during its lifetime.
class WithoutInterrupts {
  public:
    WithoutInterrupts() { asm volatile("pushfl; popl %0; cli" : "=r"(flags_)::"memory"); }
    ~WithoutInterrupts() { asm volatile("pushl %0; popfl" ::"r"(flags_) : "memory", "cc"); }
    WithoutInterrupts(const WithoutInterrupts&) = delete;
    WithoutInterrupts& operator=(const WithoutInterrupts&) = delete;

  private:
    std::uint32_t flags_;
};

}  // namespace oblong::dos
