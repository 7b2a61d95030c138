#pragma once

#include <cstdint>

// The game's own calls to the kernel, beside Linux's system calls: INT 80h with one of these numbers in eax, and in ebx
// the address of the result.

namespace oblong::dos {

enum class Call : std::uint32_t {
    Clock = 1000,  ///< ebx: std::uint64_t, counts of the timer since the start, kTimerHz a second
    Key,           ///< returns the next byte from the keyboard (scan codes of set 1), or -1
    Mouse,         ///< ebx: MouseState; resets its motion
    Idle,          ///< waits for the next interrupt
    Memory,        ///< ebx: MemoryState
    LowMemory,     ///< returns the address of kLowMemory bytes below 1 MB that cross no 64 KB boundary
    Timer          ///< ebx: the TimerHook to set
};

/// The frequency of the PC's timer (8253 or 8254): a third of the NTSC colour subcarrier.
inline constexpr std::uint32_t kTimerHz = 1'193'182;

struct MouseState {
    std::int32_t x = 0, y = 0;  ///< counts since the last call, right and down positive
    std::uint32_t buttons = 0;  ///< bit 0 left, 1 right, 2 middle
};

struct MemoryState {
    std::uint32_t size = 0;      ///< of the PC, from 1 MB on, bytes
    std::uint32_t most = 0;      ///< the most in use at any time, with the program and its files
    std::uint32_t emulated = 0;  ///< instructions that the processor lacks
    std::uint32_t stack = 0;     ///< the most used of kStackSize
};

inline constexpr std::uint32_t kLowMemory = 4096;
inline constexpr std::uint32_t kStackSize = 192 * 1024;
/// Beyond 1 MB, without sounds; kernel/start.cpp refuses less, and says it as 11 MB in all.
inline constexpr std::uint32_t kLeastMemory = 10 << 20;

/// Called at each interrupt of the timer, 291 times a second; null: nothing.
struct TimerHook {
    void (*function)(void* argument) = nullptr;
    void* argument = nullptr;
};

inline std::int32_t call(Call number, void* argument = nullptr) {
    std::int32_t result;
    asm volatile("int $0x80" : "=a"(result) : "a"(number), "b"(argument) : "memory");
    return result;
}

}  // namespace oblong::dos
