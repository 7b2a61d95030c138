#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"

extern "C" void go_to_dos(std::uint32_t segments, const void* far_address);  // entry.S
extern "C" const char resume_from_dos[];

namespace oblong::dos {
namespace {

const BootInfo* boot;
constexpr std::uint16_t kSerial = 0x3f8, kLineState = 0x3fd;  // COM1
constexpr int kLongestWait = 20'000;
// The last text that was put: the reason why the program ends.
constexpr std::uint32_t kKept = 512;
char kept[kKept];
std::uint32_t kept_end;

void start_serial() {
    constexpr std::uint8_t kSetSpeed = 0x80, k8Bits = 0x03, kBuffers = 0x07;
    write_port(kSerial + 1, 0);
    write_port(kSerial + 3, kSetSpeed);
    write_port(kSerial, 1);  // 115,200 bits a second
    write_port(kSerial + 1, 0);
    write_port(kSerial + 3, k8Bits);
    write_port(kSerial + 2, kBuffers);
}

struct [[gnu::packed]] FarAddress {
    std::uint32_t offset;
    std::uint16_t segment;
};

// Converts line ends to DOS's.
void write_message(char* to, std::uint32_t room) {
    std::uint32_t at = kept_end > kKept ? kept_end - kKept : 0, size = 0;
    for (; at < kept_end && size + 3 < room; ++at) {
        const char letter = kept[at % kKept];
        if (letter == '\n') to[size++] = '\r';
        to[size++] = letter;
    }
    to[size] = 0;
}

}  // namespace

void note_boot(const BootInfo& info) {
    boot = &info;
    start_serial();
}

const char* command_line() {
    return boot->words;
}

// The program segment prefix, which contains the command line, has the segment of the variables, each terminated by 0.
const char* dos_variable(const char* name) {
    constexpr std::uint32_t kWords = 0x81, kVariables = 0x2c;
    if (boot->dos == nullptr) return nullptr;
    const auto segment = *reinterpret_cast<const std::uint16_t*>(boot->words - kWords + kVariables);
    for (const char* at = reinterpret_cast<const char*>(std::uint32_t{segment} << 4); *at != 0; ++at) {
        std::uint32_t same = 0;
        while (name[same] != 0 && at[same] == name[same]) ++same;
        if (name[same] == 0 && at[same] == '=') return at;
        while (*at != 0) ++at;
    }
    return nullptr;
}

// A part of the buffer that dos_files.cpp does not use.
std::uint8_t* low_memory() {
    return reinterpret_cast<std::uint8_t*>(whole_pages(reinterpret_cast<std::uint32_t>(boot->buffer) + 0x8000));
}

void put(char letter) {
    kept[kept_end++ % kKept] = letter;
    constexpr std::uint8_t kMaySend = 0x20;
    for (int i = 0; i < kLongestWait && (read_port(kLineState) & kMaySend) == 0; ++i) {
    }
    write_port(kSerial, static_cast<std::uint8_t>(letter));
}

void put(const char* text) {
    while (*text != 0) put(*text++);
}

void put_hexadecimal(std::uint32_t value) {
    for (int shift = 28; shift >= 0; shift -= 4) put("0123456789abcdef"[value >> shift & 15]);
}

std::uint8_t* dos_buffer() {
    return boot->dos != nullptr ? boot->buffer : nullptr;
}

// During the call, timer and interrupts are DOS's, except those of keyboard and mouse.
std::int32_t call_dos(std::uint16_t ax, std::uint16_t bx, std::uint16_t cx, std::uint16_t dx, std::uint16_t di) {
    if (boot->dos == nullptr) return -1;
    const WithoutInterrupts during;
    DosCall& dos = *boot->dos;
    dos.resume = reinterpret_cast<std::uint32_t>(resume_from_dos);
    dos.ax = ax;
    dos.bx = bx;
    dos.cx = cx;
    dos.dx = dx;
    dos.di = di;
    dos.is_asked = 1;
    restore_clock();
    restore_interrupts(false);
    const FarAddress there{boot->leave_offset, 0x18};
    go_to_dos(boot->segments, &there);
    take_interrupts();
    start_clock();
    return dos.has_failed != 0 ? -1 : dos.ax;
}

void leave(std::uint8_t exit_code) {
    asm volatile("cli");
    restore_clock();
    restore_interrupts(true);
    write_message(boot->message, boot->message_size);
    *boot->exit_code = exit_code;
    const FarAddress there{boot->leave_offset, 0x18};
    asm volatile("lgdt (%0); ljmp *%1" ::"r"(boot->segments), "m"(there));
    for (;;) {
    }
}

void fail(const Registers& registers) {
    put("oblong: the processor has stopped the game: interrupt ");
    put_hexadecimal(registers.number);
    put(", code ");
    put_hexadecimal(registers.code);
    put(", at ");
    put_hexadecimal(registers.eip);
    put(":");
    for (std::uint32_t i = 0; i < 8; ++i) {
        put(' ');
        put_hexadecimal(reinterpret_cast<const std::uint8_t*>(registers.eip)[i]);
    }
    put("\n");
    leave(1);
}

}  // namespace oblong::dos
