#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/platform/dos/calls.h"
#include "engine/platform/dos/kernel/boot_info.h"

// What the kernel's files offer each other. It has one program to serve and one PC to drive, which are its state.

namespace oblong::dos {

/// The registers of what an interrupt has stopped, as entry.S pushes them.
struct Registers {
    std::uint32_t edi, esi, ebp, esp, ebx, edx, ecx, eax;
    std::uint32_t number, code;  ///< of the interrupt; the processor's code of an error
    std::uint32_t eip, cs, flags;
    /// The stack pointer before the interrupt.
    std::uint32_t stack() const { return reinterpret_cast<std::uint32_t>(this + 1); }
};

// interrupts.cpp
void start_interrupts();
/// As DOS had them; all lines, or those but of keyboard and mouse.
void restore_interrupts(bool has_keys);
/// After that.
void take_interrupts();

// clock.cpp
void start_clock();
void restore_clock();
void tick_clock();
/// After the interrupt has been answered.
void call_timer_hook();
void set_timer_hook(const TimerHook& hook);
/// Counts of the timer, kTimerHz a second.
std::uint64_t clock_counts();

// keyboard_and_mouse.cpp
void start_mouse();
void take_key_byte();
void take_mouse_byte();
int next_key_byte();
MouseState take_mouse();

// memory.cpp: pages of 4 KB from the program's end to the end of memory.
inline constexpr std::uint32_t kPage = 4096;
constexpr std::uint32_t whole_pages(std::uint32_t bytes) {
    return (bytes + kPage - 1) & ~(kPage - 1);
}
void start_memory(std::uint32_t first_free);
/// The program's heap, as Linux's brk: its end, which moves to `wanted` if there is room.
std::uint32_t move_heap_end(std::uint32_t wanted);
/// Zeroed pages, from the top of memory down; null if there are not so many together.
void* take_pages(std::uint32_t bytes);
/// The whole pages among these bytes.
void free_pages(const void* bytes, std::uint32_t size);
MemoryState memory_state();

// files.cpp: those of the archive behind the program, and what the game writes, which stays in memory.
void start_files(const std::uint8_t* archive);
std::int32_t system_call_of_files(Registers& registers, bool& is_known);

// dos_files.cpp: what the game writes into its folder, /oblong, in a file of DOS; without DOS that is not there.
/// Those of an earlier run become files.
void read_kept_files();
/// Writes them all; an Error where that fails: the file of DOS is as it was then.
std::int32_t keep_files();

// system_calls.cpp
std::int32_t system_call(Registers& registers);

// missing_instructions.cpp
/// Does what an instruction would have done that a 486 does not know; false if that is none of them.
bool emulate(Registers& registers);
std::uint32_t emulated_instructions();

// leave.cpp
void note_boot(const BootInfo& boot);
const char* command_line();
/// A variable of DOS, as NAME=VALUE; null: there is none.
const char* dos_variable(const char* name);
/// kLowMemory bytes.
std::uint8_t* low_memory();
/// What DOS returns in AX, with its buffer at `buffer`; -1 where it has failed, or is not there.
std::int32_t call_dos(std::uint16_t ax, std::uint16_t bx, std::uint16_t cx, std::uint16_t dx, std::uint16_t di = 0);
/// Null without DOS.
std::uint8_t* dos_buffer();
/// Sends a character to the serial port, and keeps it for the message on leaving.
void put(char letter);
void put(const char* text);
void put_hexadecimal(std::uint32_t value);
/// Back to DOS, or halts; what was put last is on the screen then.
[[noreturn]] void leave(std::uint8_t exit_code);
[[noreturn]] void fail(const Registers& registers);

}  // namespace oblong::dos

// The compiler calls these by itself.
extern "C" {
void* memcpy(void* to, const void* from, std::size_t count);
void* memset(void* to, int value, std::size_t count);
}
