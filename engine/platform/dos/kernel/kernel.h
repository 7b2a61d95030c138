#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/platform/dos/calls.h"

// Functions shared by the kernel's files. Its state is global: it serves one program on one PC.

namespace oblong::dos {

/// A call of DOS (INT 21h), both data segments at BootInfo::buffer; and where the loader continues after it.
struct [[gnu::packed]] DosCall {
    std::uint32_t resume;
    std::uint16_t resume_segment, ax, bx, cx, dx, di, has_failed;
    std::uint8_t is_asked;
};

/// Data from the loader (loader.S). Addresses are physical, below 1 MB.
struct BootInfo {
    std::uint32_t segments;      ///< address of the LGDT operand for the loader's segments
    std::uint32_t leave_offset;  ///< in segment 0x18 of those: returns to real mode, prints the message, ends
    char* words;                 ///< of the command line; end with a carriage return
    char* message;               ///< room for a text that ends with 0
    std::uint32_t message_size;
    std::uint8_t* exit_code;
    DosCall* dos;          ///< null: started from a disk
    std::uint8_t* buffer;  ///< 64 KB
};

/// The registers of the interrupted code, as entry.S pushes them.
struct Registers {
    std::uint32_t edi, esi, ebp, esp, ebx, edx, ecx, eax;
    std::uint32_t number, code;  ///< of the interrupt; the processor's code of an error
    std::uint32_t eip, cs, flags;
    /// The stack pointer before the interrupt.
    std::uint32_t stack() const { return reinterpret_cast<std::uint32_t>(this + 1); }
};

// interrupts.cpp
void start_interrupts();
/// Restores DOS's interrupts; `has_keys`: also of keyboard and mouse.
void restore_interrupts(bool has_keys);
/// Takes them over again.
void take_interrupts();

// clock.cpp
void start_clock();
void restore_clock();
void tick_clock();
/// Called after the interrupt is acknowledged.
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
/// Linux's brk: moves the heap's end to `wanted` if there is room; returns the end.
std::uint32_t move_heap_end(std::uint32_t wanted);
/// Zeroed contiguous pages, from the top of memory down; null if there are too few.
void* take_pages(std::uint32_t bytes);
/// The lowest of the program's kStackSize bytes; null if there is too little memory.
std::uint8_t* take_stack();
/// Frees the whole pages among these bytes.
void free_pages(const void* bytes, std::uint32_t size);
MemoryState memory_state();

// files.cpp: files of the archive behind the program, and files that the game writes, which stay in memory.
void start_files(const std::uint8_t* archive);
std::int32_t system_call_of_files(const Registers& registers, bool& is_known);

// dos_files.cpp: stores files of the game's folder, /oblong, in a DOS file; without DOS there is no such folder.
/// Reads the files of an earlier run.
void read_kept_files();
/// Writes them all; on an Error the DOS file is unchanged.
std::int32_t keep_files();

// system_calls.cpp
std::int32_t system_call(const Registers& registers);

// missing_instructions.cpp
/// Emulates an instruction that a 486 lacks; false for any other.
bool emulate(Registers& registers);
std::uint32_t emulated_instructions();

// leave.cpp
void note_boot(const BootInfo& boot);
const char* command_line();
/// A variable of DOS, as NAME=VALUE; null: none.
const char* dos_variable(const char* name);
/// kLowMemory bytes.
std::uint8_t* low_memory();
/// Calls DOS with its data segments at dos_buffer(); returns AX, or -1 if it failed or there is no DOS.
std::int32_t call_dos(std::uint16_t ax, std::uint16_t bx, std::uint16_t cx, std::uint16_t dx, std::uint16_t di = 0);
/// Null without DOS.
std::uint8_t* dos_buffer();
/// Sends a character to the serial port, and stores it for the message at the end.
void put(char letter);
void put(const char* text);
void put_hexadecimal(std::uint32_t value);
/// Returns to DOS, or halts; shows the text that was put last.
[[noreturn]] void leave(std::uint8_t exit_code);
[[noreturn]] void fail(const Registers& registers);

}  // namespace oblong::dos

// Called by generated code.
extern "C" {
void* memcpy(void* to, const void* from, std::size_t count);
void* memset(void* to, int value, std::size_t count);
}
