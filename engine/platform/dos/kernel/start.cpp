#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"
#include "engine/platform/dos/layout.h"

// Segments, devices, and the program: a static Linux program loaded at PROGRAM_ADDRESS (ELF), with the archive of its
// files on the next page.

namespace oblong::dos {
namespace {

constexpr std::uint32_t kThreadSegment = 6;
std::uint64_t segments[kThreadSegment + 1];

void start_segments() {
    segments[1] = 0x00cf9a000000ffff;  // 0x08: all memory, code
    segments[2] = 0x00cf92000000ffff;  // 0x10: all memory, data
    struct [[gnu::packed]] {
        std::uint16_t limit;
        const std::uint64_t* table;
    } const where{sizeof segments - 1, segments};
    asm volatile("lgdt %0; ljmp $0x08, $1f; 1:" ::"m"(where));
}

// The C library needs floating point; its exceptions stay masked.
void start_coprocessor() {
    constexpr std::uint32_t kEmulation = 1 << 2, kTaskSwitched = 1 << 3, kMonitor = 1 << 1, kReports = 1 << 5;
    std::uint32_t cr0;
    asm volatile("movl %%cr0, %0" : "=r"(cr0));
    cr0 = (cr0 & ~(kEmulation | kTaskSwitched)) | kMonitor | kReports;
    asm volatile("movl %0, %%cr0; fninit" ::"r"(cr0));
}

// Enables SSE, which the C library uses if a processor (Pentium III or later) has it.
void start_wide_registers() {
    std::uint32_t before, after;
    asm volatile("pushfl; popl %0; movl %0, %1; xorl $0x200000, %0; pushl %0; popfl; pushfl; popl %0"
                 : "=&r"(after), "=&r"(before)::"cc");
    if (before == after) return;  // no CPUID
    std::uint32_t leaf = 1, b, c, features;
    asm volatile("cpuid" : "+a"(leaf), "=b"(b), "=c"(c), "=d"(features));
    constexpr std::uint32_t kSse = 1 << 25, kSaved = 0x600;
    if ((features & kSse) == 0) return;
    std::uint32_t cr4;
    asm volatile("movl %%cr4, %0" : "=r"(cr4));
    asm volatile("movl %0, %%cr4" ::"r"(cr4 | kSaved));
}

struct ElfHeader {
    std::uint8_t identity[24];
    std::uint32_t entry, headers_offset;
    std::uint8_t unused[12];
    std::uint16_t header_size, header_count;
};
struct ElfPart {
    std::uint32_t kind, offset, address, physical, file_size, memory_size, flags, alignment;
};

// An entry of the auxiliary vector that Linux passes to a program: elf.h's AT_...
struct AuxiliaryEntry {
    std::uint32_t type, value;
};

// Splits a command line into words, each terminated by 0, in `room`; returns their number.
std::uint32_t split_words(const char* line, char* room, std::uint32_t room_size, std::uint32_t* words,
                          std::uint32_t most) {
    std::uint32_t count = 0, size = 0;
    while (*line == ' ') ++line;
    while (*line != '\r' && *line != 0 && count < most && size + 2 < room_size) {
        words[count++] = reinterpret_cast<std::uint32_t>(room + size);
        while (*line != ' ' && *line != '\r' && *line != 0 && size + 2 < room_size) room[size++] = *line++;
        room[size++] = 0;
        while (*line == ' ') ++line;
    }
    return count;
}

[[noreturn]] void start_program() {
    const auto& elf = *reinterpret_cast<const ElfHeader*>(PROGRAM_ADDRESS);
    const std::uint32_t headers = PROGRAM_ADDRESS + elf.headers_offset;
    const auto* const parts = reinterpret_cast<const ElfPart*>(headers);
    std::uint32_t end = 0;
    for (std::uint32_t i = 0; i < elf.header_count; ++i) {
        constexpr std::uint32_t kLoaded = 1;
        if (parts[i].kind == kLoaded && parts[i].address + parts[i].memory_size > end)
            end = parts[i].address + parts[i].memory_size;
    }
    const auto* const archive = reinterpret_cast<const std::uint8_t*>(whole_pages(end));
    start_files(archive);
    start_memory(whole_pages(end) + reinterpret_cast<const std::uint32_t*>(archive)[1]);
    std::uint8_t* const stack = take_stack();
    if (stack == nullptr || memory_state().size < kLeastMemory) {
        put("oblong: there is too little memory, expected 11 MB\n");
        leave(1);
    }
    read_kept_files();
    static char name[] = "/oblong", folder[] = "HOME=/", room[256];
    static std::uint8_t random[16] = {1, 2, 3};
    constexpr std::uint32_t kMostWords = 32;
    std::uint32_t words[kMostWords];
    const std::uint32_t count = split_words(command_line(), room, sizeof room, words, kMostWords);
    auto* const first = reinterpret_cast<std::uint32_t*>(stack + kStackSize - 1024);
    std::uint32_t* at = first;
    *at++ = count + 1;
    *at++ = reinterpret_cast<std::uint32_t>(name);
    for (std::uint32_t i = 0; i < count; ++i) *at++ = words[i];
    *at++ = 0;
    *at++ = reinterpret_cast<std::uint32_t>(folder);
    if (const char* const card = dos_variable("BLASTER")) *at++ = reinterpret_cast<std::uint32_t>(card);
    *at++ = 0;
    const AuxiliaryEntry entries[] = {{3, headers},
                                      {4, sizeof(ElfPart)},
                                      {5, elf.header_count},
                                      {6, kPage},
                                      {9, elf.entry},
                                      {11, 0},
                                      {12, 0},
                                      {13, 0},
                                      {14, 0},
                                      {17, 100},
                                      {23, 0},
                                      {25, reinterpret_cast<std::uint32_t>(random)},
                                      {0, 0}};
    memcpy(at, entries, sizeof entries);
    asm volatile("movl %0, %%esp; sti; xorl %%edx, %%edx; xorl %%ebp, %%ebp; jmp *%1" ::"r"(first), "r"(elf.entry)
                 : "memory");
    for (;;) {
    }
}

}  // namespace

void set_thread_segment(std::uint32_t address) {
    constexpr std::uint64_t kData = 0x00cff2000000ffff;
    segments[kThreadSegment] = kData | std::uint64_t{address & 0xffffff} << 16 | std::uint64_t{address >> 24} << 56;
}

extern "C" [[noreturn]] void start_kernel(const BootInfo* boot);
void start_kernel(const BootInfo* boot) {
    note_boot(*boot);
    start_segments();
    start_interrupts();
    start_clock();
    start_mouse();
    start_coprocessor();
    start_wide_registers();
    start_program();
}

}  // namespace oblong::dos

// By words of 4 bytes, then by the bytes that are left.
void* memcpy(void* to, const void* from, std::size_t count) {
    void* const result = to;
    std::size_t words = count / 4, rest = count % 4;
    asm volatile("rep movsl" : "+D"(to), "+S"(from), "+c"(words)::"memory");
    asm volatile("rep movsb" : "+D"(to), "+S"(from), "+c"(rest)::"memory");
    return result;
}
void* memset(void* to, int value, std::size_t count) {
    void* const result = to;
    std::size_t words = count / 4, rest = count % 4;
    const std::uint32_t word = static_cast<std::uint8_t>(value) * 0x01010101u;
    asm volatile("rep stosl" : "+D"(to), "+c"(words) : "a"(word) : "memory");
    asm volatile("rep stosb" : "+D"(to), "+c"(rest) : "a"(word) : "memory");
    return result;
}
