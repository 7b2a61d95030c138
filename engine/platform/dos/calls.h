#pragma once

#include <cstdint>

// What the game asks of the kernel beside Linux's system calls: INT 80h with one of these numbers in eax, and the
// address of what it fills in ebx.

namespace oblong::dos {

enum class Call : std::uint32_t {
    Clock = 1000,  ///< ebx: std::uint64_t, counts of the timer since the start, kTimerHz a second
    Key,           ///< returns the next byte from the keyboard (scan codes of set 1), or -1
    Mouse,         ///< ebx: MouseState; its motion begins anew
    Idle,          ///< until the next interrupt
    Memory,        ///< ebx: MemoryState
    LowMemory,     ///< returns the address of kLowMemory bytes below 1 MB, which cross no boundary of 64 KB
    Timer          ///< ebx: TimerHook, from now on
};

/// What the PC's timer (an 8253 or 8254) counts by: a third of the colour subcarrier of American television.
inline constexpr std::uint32_t kTimerHz = 1'193'182;

struct MouseState {
    std::int32_t x = 0, y = 0;  ///< counts since the last call, right and down positive
    std::uint32_t buttons = 0;  ///< bit 0 left, 1 right, 2 middle
};

struct MemoryState {
    std::uint32_t size = 0;      ///< of the PC, from 1 MB on, bytes
    std::uint32_t most = 0;      ///< of that in use at any time, the program and its files with it
    std::uint32_t emulated = 0;  ///< instructions that the processor did not know
};

inline constexpr std::uint32_t kLowMemory = 4096;

/// What each interrupt of the timer calls, 291 times a second; null: nothing.
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
