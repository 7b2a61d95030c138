#include "engine/platform/dos/kernel/file_table.h"
#include "engine/platform/dos/kernel/kernel.h"

// Linux's system calls, by number (asm/unistd_32.h), as far as the C and C++ libraries use them. Others fail, and are
// reported on the serial port.

namespace oblong::dos {

void set_thread_segment(std::uint32_t address);  // start.cpp

namespace {

constexpr std::int32_t kNotThere = -38, kNoDevice = -19, kTryLater = -11;

struct TimeOfCall {
    std::uint32_t seconds, nanoseconds;
};

TimeOfCall time_now() {
    const std::uint64_t counts = clock_counts();
    std::uint32_t seconds, rest, nanoseconds, unused;
    asm("divl %4"
        : "=a"(seconds), "=d"(rest)
        : "a"(static_cast<std::uint32_t>(counts)), "d"(static_cast<std::uint32_t>(counts >> 32)), "r"(kTimerHz));
    const std::uint64_t scaled = std::uint64_t{rest} * 1'000'000'000u;
    asm("divl %4"
        : "=a"(nanoseconds), "=d"(unused)
        : "a"(static_cast<std::uint32_t>(scaled)), "d"(static_cast<std::uint32_t>(scaled >> 32)), "r"(kTimerHz));
    return {seconds, nanoseconds};
}

std::int32_t write_time(std::uint32_t address, bool has_64_bits) {
    const TimeOfCall now = time_now();
    auto* const to = reinterpret_cast<std::uint32_t*>(address);
    to[0] = now.seconds;
    to[1] = has_64_bits ? 0 : now.nanoseconds;
    if (has_64_bits) to[2] = now.nanoseconds, to[3] = 0;
    return 0;
}

std::int32_t take_mapping(const Registers& registers) {
    constexpr std::uint32_t kNoFile = 0xffffffff;
    if (registers.edi != kNoFile) return kNoDevice;
    void* const pages = take_pages(registers.ecx);
    return pages == nullptr ? kNoMemory : reinterpret_cast<std::int32_t>(pages);
}

std::int32_t limits(std::uint32_t address, bool has_64_bits) {
    auto* const to = reinterpret_cast<std::uint32_t*>(address);
    if (to == nullptr) return 0;
    to[0] = kStackSize;
    to[1] = has_64_bits ? 0 : kStackSize;
    if (has_64_bits) to[2] = kStackSize, to[3] = 0;
    return 0;
}

std::int32_t thread_area(std::uint32_t* description) {
    constexpr std::uint32_t kEntry = 6;
    description[0] = kEntry;
    set_thread_segment(description[1]);
    return 0;
}

// The same numbers in each run.
std::int32_t fill_random(std::uint8_t* to, std::uint32_t size) {
    for (std::uint32_t i = 0; i < size; ++i) to[i] = static_cast<std::uint8_t>(i * 37 + 11);
    return static_cast<std::int32_t>(size);
}

std::int32_t own_call(const Registers& registers, bool& is_known) {
    switch (static_cast<Call>(registers.eax)) {
        case Call::Clock:
            *reinterpret_cast<std::uint64_t*>(registers.ebx) = clock_counts();
            return 0;
        case Call::Key:
            return next_key_byte();
        case Call::Mouse:
            *reinterpret_cast<MouseState*>(registers.ebx) = take_mouse();
            return 0;
        case Call::Idle:
            asm volatile("sti; hlt");
            return 0;
        case Call::Memory:
            *reinterpret_cast<MemoryState*>(registers.ebx) = memory_state();
            return 0;
        case Call::LowMemory:
            return reinterpret_cast<std::int32_t>(low_memory());
        case Call::Timer:
            set_timer_hook(*reinterpret_cast<const TimerHook*>(registers.ebx));
            return 0;
    }
    is_known = false;
    return 0;
}

/// Calls that always have the same result.
struct Answer {
    std::int32_t result;
    std::uint16_t calls[12];  // 0: none
};
constexpr Answer kAnswers[] = {
    {1, {20, 24, 47, 49, 50, 199, 200, 201, 202, 224, 258}},  // ids of process, thread, user, group
    {0, {125, 219, 240}},                                     // mprotect, madvise, futex
    {0, {174, 175, 311}},                                     // signals, robust list
    {0, {162, 267, 407}},                                     // nanosleep
    {0, {118, 148}},                                          // fsync
    {0, {55, 221}},                                           // fcntl: no other program locks files
    {kInvalid, {85, 305}},                                    // readlink: there are no links
    {kNoMemory, {163}},                                       // mremap
    {kNoTerminal, {54}},                                      // ioctl
    {kTryLater, {120, 435}},                                  // clone: there are no other threads
    {kNotThere, {386}},                                       // rseq
};

std::int32_t answered_call(const Registers& registers, bool& is_known) {
    for (const Answer& answer : kAnswers)
        for (const std::uint16_t call : answer.calls)
            if (call != 0 && call == registers.eax) return answer.result;
    is_known = false;
    return 0;
}

std::int32_t call_of_process(const Registers& registers, bool& is_known) {
    const std::uint32_t b = registers.ebx, c = registers.ecx;
    switch (registers.eax) {
        case 1:
        case 252:
            leave(static_cast<std::uint8_t>(b));  // exit
        case 45:
            return static_cast<std::int32_t>(move_heap_end(b));
        case 91:
            free_pages(reinterpret_cast<void*>(b), whole_pages(c));
            return 0;  // munmap
        case 192:
            return take_mapping(registers);
        case 238:
        case 270:
            leave(1);  // tkill: abort()
        case 191:
            return limits(c, false);
        case 340:
            return registers.esi == 0 ? 0 : limits(registers.esi, true);
        case 243:
            return thread_area(reinterpret_cast<std::uint32_t*>(b));
        case 265:
            return write_time(c, false);
        case 403:
            return write_time(c, true);
        case 355:
            return fill_random(reinterpret_cast<std::uint8_t*>(b), c);
        default:
            is_known = false;
            return 0;
    }
}

}  // namespace

std::int32_t system_call(const Registers& registers) {
    using Group = std::int32_t (*)(const Registers&, bool&);
    constexpr Group kGroups[] = {system_call_of_files, answered_call, call_of_process, own_call};
    for (const Group group : kGroups) {
        bool is_known = true;
        const std::int32_t result = group(registers, is_known);
        if (is_known) return result;
    }
    put("[system call ");
    put_hexadecimal(registers.eax);
    put("]\n");
    return kNotThere;
}

}  // namespace oblong::dos
